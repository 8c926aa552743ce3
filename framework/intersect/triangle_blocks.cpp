#include "intersect/triangle_blocks.h"

#include "intersect/triangle_pairs.h"

#include <algorithm>

namespace pathmark {

namespace {

// Of the corners as they are in float: the normal of a thin triangle in the scene may be that of
// corners that were not rounded yet.
Float3 normalOf(const std::array<Float3, 3>& corners) {
  const auto corner = [&](std::size_t k) {
    return glm::dvec3(corners[k][0], corners[k][1], corners[k][2]);
  };
  const Vector n(glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0))));
  return {n.x, n.y, n.z};
}

}  // namespace

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
    for (std::size_t k = 0; k < 2; ++k) {
      block.index[k].lane[lane] = present ? static_cast<float>(pairs[i].triangle[k]) : 0.0f;
      // The plane of no triangle is met nowhere.
      const bool triangle = present && !(k == 1 && pairs[i].single);
      const Float3 n = triangle ? normalOf(scene.corners(scene.triangles[pairs[i].triangle[k]]))
                                : Float3{kNaN, kNaN, kNaN};
      for (std::size_t axis = 0; axis < 3; ++axis) block.normal[k][axis].lane[lane] = n[axis];
    }
    const bool frontOnly = present && scene.frontOnly(scene.triangles[pairs[i].triangle[0]]);
    block.largestSlope.lane[lane] = frontOnly ? 0.0f : kInfinity;
    culls_ = culls_ || frontOnly;
  }
}

// A corner of each pair, with the ray as the z axis.
struct TriangleBlocks::Corner {
  FloatV x, y;

  Corner(const LaneArray (&vertex)[3], const RayShear& r) {
    const FloatV z = load(vertex[r.kz]) - r.oz;
    x = (load(vertex[r.kx]) - r.ox) - r.sx * z;
    y = (load(vertex[r.ky]) - r.oy) - r.sy * z;
  }
};

// The edge function of the ray and the edge q p: twice the area of the triangle that they span.
inline FloatV TriangleBlocks::edge(const Corner& p, const Corner& q) {
  return p.x * q.y - p.y * q.x;
}

// Which of a pair's triangles the line of the ray meets.
struct TriangleBlocks::Met {
  FloatV::mask_type first, second;
};

inline TriangleBlocks::Met TriangleBlocks::meet(const Block& block, const RayShear& r) {
  const Corner a(block.vertex[0], r), b(block.vertex[1], r), c(block.vertex[2], r),
      d(block.vertex[3], r);
  const FloatV ab = edge(b, a), bc = edge(c, b), ca = edge(a, c);
  const FloatV cd = edge(d, c), da = edge(a, d), ac = -ca;
  return {min(min(ab, bc), ca) >= 0.0f || max(max(ab, bc), ca) <= 0.0f,
          min(min(cd, da), ac) >= 0.0f || max(max(cd, da), ac) <= 0.0f};
}

// Where the ray meets the planes through the pairs' first corners. Interpolating the distances of
// all corners would lose as many digits as a triangle is longer than high: rays that leave a thin
// one would meet it again. Differences first: far from the origin all products are large. A ray in
// the plane divides by 0, and meets nothing.
template <bool kCulls>
inline FloatV TriangleBlocks::planeDistance(const Block& block, const FloatV (&n)[3],
                                            const Point& origin, const Vector& direction) {
  const auto& a = block.vertex[0];
  FloatV slope = n[0] * direction.x + n[1] * direction.y + n[2] * direction.z;
  if constexpr (kCulls) where(!(slope < load(block.largestSlope)), slope) = kNaN;
  return (n[0] * (load(a[0]) - origin.x) + n[1] * (load(a[1]) - origin.y) +
          n[2] * (load(a[2]) - origin.z)) /
         slope;
}

template <bool kCulls>
inline FloatV TriangleBlocks::firstDistance(const Block& block, const Point& origin,
                                            const Vector& direction) {
  const auto& n = block.normal[0];
  return planeDistance<kCulls>(block, {load(n[0]), load(n[1]), load(n[2])}, origin, direction);
}

// Of the second triangle where both are met: on the common edge, or where one hides the other.
template <bool kCulls>
inline FloatV TriangleBlocks::distance(const Block& block, const Met& met, const Point& origin,
                                       const Vector& direction) {
  const auto choose = [&](std::size_t axis) {
    FloatV value = load(block.normal[0][axis]);
    where(met.second, value) = load(block.normal[1][axis]);
    return value;
  };
  return planeDistance<kCulls>(block, {choose(0), choose(1), choose(2)}, origin, direction);
}

template <bool kCulls>
bool TriangleBlocks::closestOf(const Ray& ray, float tMax, PrimitiveHit& hit) const {
  const RayShear shear(ray.origin, ray.direction);
  NearestV nearest(tMax);
  for (const Block& block : blocks_) {
    const Met met = meet(block, shear);
    FloatV index = load(block.index[0]);
    where(met.second, index) = load(block.index[1]);
    nearest.take(met.first || met.second, distance<kCulls>(block, met, ray.origin, ray.direction),
                 index);
    if (any_of(met.first && met.second)) [[unlikely]]
      nearest.take(met.first, firstDistance<kCulls>(block, ray.origin, ray.direction),
                   load(block.index[0]));
  }
  if (!nearest.reduce(tMax, hit)) return false;
  hit.isSphere = false;
  return true;
}

template <bool kCulls>
bool TriangleBlocks::occludedOf(const Point& origin, const Vector& segment) const {
  const RayShear shear(origin, segment);
  const auto within = [](const FloatV& t) { return t > 0.0f && t < 1.0f; };
  for (const Block& block : blocks_) {
    const Met met = meet(block, shear);
    if (any_of((met.first || met.second) && within(distance<kCulls>(block, met, origin, segment))))
      return true;
    if (any_of(met.first && met.second)) [[unlikely]]
      if (any_of(met.first && within(firstDistance<kCulls>(block, origin, segment)))) return true;
  }
  return false;
}

bool TriangleBlocks::closest(const Ray& ray, float tMax, PrimitiveHit& hit) const {
  return culls_ ? closestOf<true>(ray, tMax, hit) : closestOf<false>(ray, tMax, hit);
}

bool TriangleBlocks::occluded(const Point& origin, const Vector& segment) const {
  return culls_ ? occludedOf<true>(origin, segment) : occludedOf<false>(origin, segment);
}

}  // namespace pathmark
