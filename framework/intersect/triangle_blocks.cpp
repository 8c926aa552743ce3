#include "intersect/triangle_blocks.h"

#include "intersect/triangle_pairs.h"

#include <algorithm>

namespace pathmark {

namespace {

// n and w of the plane n . p = w, of the corners as they are in float: the normal of a thin
// triangle in the scene may be that of corners that were not rounded yet.
std::array<float, 4> planeOf(const std::array<Float3, 3>& corners) {
  const auto corner = [&](std::size_t k) {
    return glm::dvec3(corners[k][0], corners[k][1], corners[k][2]);
  };
  const Vector n(glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0))));
  return {n.x, n.y, n.z, static_cast<float>(glm::dot(glm::dvec3(n), corner(0)))};
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
      const auto plane = present ? planeOf(scene.corners(scene.triangles[pairs[i].triangle[k]]))
                                 : std::array{kNaN, kNaN, kNaN, kNaN};
      for (std::size_t c = 0; c < 4; ++c) block.plane[k][c].lane[lane] = plane[c];
    }
    const bool frontOnly =
        present && scene.shapes[scene.triangles[pairs[i].triangle[0]].shape].frontOnly != 0;
    block.smallestArea.lane[lane] = frontOnly ? 0.0f : -kInfinity;
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

template <bool kCulls>
inline TriangleBlocks::Met TriangleBlocks::meet(const Block& block, const RayShear& r) {
  const Corner a(block.vertex[0], r), b(block.vertex[1], r), c(block.vertex[2], r),
      d(block.vertex[3], r);
  const FloatV ab = edge(b, a), bc = edge(c, b), ca = edge(a, c);
  const FloatV cd = edge(d, c), da = edge(a, d), ac = -ca;
  const FloatV firstArea = ab + bc + ca, secondArea = cd + da + ac;
  Met met{min(min(ab, bc), ca) >= 0.0f || max(max(ab, bc), ca) <= 0.0f,
          min(min(cd, da), ac) >= 0.0f || max(max(cd, da), ac) <= 0.0f};
  if constexpr (kCulls) {
    const FloatV smallest = load(block.smallestArea);
    met.first = met.first && firstArea > smallest;
    met.second = met.second && secondArea > smallest;
  }
  met.first = met.first && firstArea != 0.0f;
  met.second = met.second && secondArea != 0.0f;
  return met;
}

// Where the ray meets the planes n . p = w. Interpolating the distances of the corners would lose
// as many digits as a triangle is longer than high: rays that leave a thin one would meet it again.
inline FloatV TriangleBlocks::planeDistance(const FloatV (&plane)[4], const Point& origin,
                                            const Vector& direction) {
  const auto& [x, y, z, w] = plane;
  return (w - (x * origin.x + y * origin.y + z * origin.z)) /
         (x * direction.x + y * direction.y + z * direction.z);
}

inline FloatV TriangleBlocks::firstDistance(const Block& block, const Point& origin,
                                            const Vector& direction) {
  const auto& plane = block.plane[0];
  return planeDistance({load(plane[0]), load(plane[1]), load(plane[2]), load(plane[3])}, origin,
                       direction);
}

// Of the second triangle where both are met: on the common edge, or where one hides the other.
inline FloatV TriangleBlocks::distance(const Block& block, const Met& met, const Point& origin,
                                       const Vector& direction) {
  const auto choose = [&](std::size_t k) {
    FloatV value = load(block.plane[0][k]);
    where(met.second, value) = load(block.plane[1][k]);
    return value;
  };
  return planeDistance({choose(0), choose(1), choose(2), choose(3)}, origin, direction);
}

template <bool kCulls>
NearestV TriangleBlocks::closestOf(const Ray& ray, float tMax) const {
  const RayShear shear(ray.origin, ray.direction);
  NearestV nearest(tMax);
  for (const Block& block : blocks_) {
    const Met met = meet<kCulls>(block, shear);
    FloatV index = load(block.index[0]);
    where(met.second, index) = load(block.index[1]);
    nearest.take(met.first || met.second, distance(block, met, ray.origin, ray.direction), index);
    if (any_of(met.first && met.second)) [[unlikely]]
      nearest.take(met.first, firstDistance(block, ray.origin, ray.direction),
                   load(block.index[0]));
  }
  return nearest;
}

template <bool kCulls>
bool TriangleBlocks::occludedOf(const Point& origin, const Vector& segment) const {
  const RayShear shear(origin, segment);
  const auto within = [](const FloatV& t) { return t > 0.0f && t < 1.0f; };
  for (const Block& block : blocks_) {
    const Met met = meet<kCulls>(block, shear);
    if (any_of((met.first || met.second) && within(distance(block, met, origin, segment))))
      return true;
    if (any_of(met.first && met.second)) [[unlikely]]
      if (any_of(met.first && within(firstDistance(block, origin, segment)))) return true;
  }
  return false;
}

bool TriangleBlocks::closest(const Ray& ray, float tMax, PrimitiveHit& hit) const {
  const NearestV nearest = culls_ ? closestOf<true>(ray, tMax) : closestOf<false>(ray, tMax);
  if (!nearest.reduce(tMax, hit)) return false;
  hit.isSphere = false;
  return true;
}

bool TriangleBlocks::occluded(const Point& origin, const Vector& segment) const {
  return culls_ ? occludedOf<true>(origin, segment) : occludedOf<false>(origin, segment);
}

}  // namespace pathmark
