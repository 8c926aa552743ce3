#include "intersect/triangle_blocks.h"

#include "intersect/triangle_pairs.h"

#include <algorithm>

namespace pathmark {

TriangleBlocks::TriangleBlocks(const FlatSceneView& scene,
                               std::span<const std::uint32_t> triangles) {
  const std::vector<TrianglePair> pairs = pairTriangles(scene, triangles);
  blocks_.resize((pairs.size() + kLanes - 1) / kLanes);
  for (std::size_t i = 0; i < blocks_.size() * kLanes; ++i) {
    Block& block = blocks_[i / kLanes];
    const std::size_t lane = i % kLanes;
    const bool present = i < pairs.size();
    for (std::size_t corner = 0; corner < 4; ++corner)
      for (std::size_t axis = 0; axis < 3; ++axis)
        block.vertex[corner][axis].lane[lane] = present ? pairs[i].corner[corner][axis] : kNaN;
    for (std::size_t k = 0; k < 2; ++k)
      block.index[k].lane[lane] = present ? static_cast<float>(pairs[i].triangle[k]) : 0.0f;
    const bool frontOnly =
        present && scene.shapes[scene.triangles[pairs[i].triangle[0]].shape].frontOnly != 0;
    block.smallestArea.lane[lane] = frontOnly ? 0.0f : -kInfinity;
    culls_ = culls_ || frontOnly;
  }
}

// Which of a pair's triangles the line of the ray meets, and where: at numerator / area.
struct TriangleBlocks::Met {
  FloatV::mask_type first, second;
  FloatV firstNumerator, firstArea, secondNumerator, secondArea;

  // The hits with one of the two. The second is told in lanes where both are met: on the common
  // edge, or where one hides the other.
  FloatV t(const RayShear& shear) const {
    FloatV numerator = firstNumerator, area = firstArea;
    where(second, numerator) = secondNumerator;
    where(second, area) = secondArea;
    return shear.sz * numerator / area;
  }
};

template <bool kCulls>
TriangleBlocks::Met TriangleBlocks::meet(const Block& block, const RayShear& r) {
  FloatV x[4], y[4], z[4];
  for (std::size_t k = 0; k < 4; ++k) {
    z[k] = load(block.vertex[k][r.kz]) - r.oz;
    x[k] = mulAdd(-r.sx, z[k], load(block.vertex[k][r.kx]) - r.ox);
    y[k] = mulAdd(-r.sy, z[k], load(block.vertex[k][r.ky]) - r.oy);
  }
  const auto edge = [&](std::size_t i, std::size_t j) { return x[i] * y[j] - y[i] * x[j]; };
  const FloatV ab = edge(1, 0), bc = edge(2, 1), ca = edge(0, 2);
  const FloatV cd = edge(3, 2), da = edge(0, 3), ac = -ca;

  Met met;
  met.first = min(min(ab, bc), ca) >= 0.0f || max(max(ab, bc), ca) <= 0.0f;
  met.second = min(min(cd, da), ac) >= 0.0f || max(max(cd, da), ac) <= 0.0f;
  met.firstArea = ab + bc + ca;
  met.secondArea = cd + da + ac;
  met.firstNumerator = mulAdd(bc, z[0], mulAdd(ca, z[1], ab * z[2]));
  met.secondNumerator = mulAdd(cd, z[0], mulAdd(da, z[2], ac * z[3]));
  if constexpr (kCulls) {
    const FloatV smallest = load(block.smallestArea);
    met.first = met.first && met.firstArea > smallest;
    met.second = met.second && met.secondArea > smallest;
  }
  return met;
}

template <bool kCulls>
NearestV TriangleBlocks::closest(const RayShear& shear, float tMax) const {
  NearestV nearest(tMax);
  for (const Block& block : blocks_) {
    const Met met = meet<kCulls>(block, shear);
    FloatV index = load(block.index[0]);
    where(met.second, index) = load(block.index[1]);
    nearest.take(met.first || met.second, met.t(shear), index);
    if (any_of(met.first && met.second)) [[unlikely]]
      nearest.take(met.first, shear.sz * met.firstNumerator / met.firstArea, load(block.index[0]));
  }
  return nearest;
}

template <bool kCulls>
bool TriangleBlocks::occluded(const RayShear& shear) const {
  const auto within = [](const FloatV& t) { return t > 0.0f && t < 1.0f; };
  for (const Block& block : blocks_) {
    const Met met = meet<kCulls>(block, shear);
    if (any_of((met.first || met.second) && within(met.t(shear)))) return true;
    if (any_of(met.first && met.second)) [[unlikely]]
      if (any_of(met.first && within(shear.sz * met.firstNumerator / met.firstArea))) return true;
  }
  return false;
}

bool TriangleBlocks::closest(const Ray& ray, float tMax, PrimitiveHit& hit) const {
  const RayShear shear(ray.origin, ray.direction);
  if (!(culls_ ? closest<true>(shear, tMax) : closest<false>(shear, tMax)).reduce(tMax, hit))
    return false;
  hit.isSphere = false;
  return true;
}

bool TriangleBlocks::occluded(const Point& origin, const Vector& segment) const {
  const RayShear shear(origin, segment);
  return culls_ ? occluded<true>(shear) : occluded<false>(shear);
}

}  // namespace pathmark
