// TriangleBlocks: a ray against all triangles, in pairs that share an edge, a vector of pairs at a
// time.
//
//   closest    the nearest triangle along a ray
//   occluded   whether any triangle lies on a segment
//
// Watertight (Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013): each
// vertex gets the same sheared coordinates in all of its triangles, and the two products of an edge
// function are rounded one by one. Rounding is monotonic, so that the sign of their difference is
// never wrong, only 0 at times, which counts as a hit on both sides: no ray slips through.
#pragma once

#include "intersect/ray_shear.h"
#include "intersect/simd.h"
#include "scene/flat_scene.h"

#include <span>
#include <vector>

namespace pathmark {

class TriangleBlocks {
 public:
  // Of these triangles of the scene.
  TriangleBlocks(const FlatSceneView& scene, std::span<const std::uint32_t> triangles);

  bool empty() const { return blocks_.empty(); }

  // Returns whether the ray meets one at 0 < t < tMax, and only then sets `hit` to the nearest.
  bool closest(const Ray& ray, float tMax, PrimitiveHit& hit) const;

  // Whether a triangle lies on origin + t * segment, 0 < t < 1.
  bool occluded(const Point& origin, const Vector& segment) const;

 private:
  // Triangles a b c and a c d: a quad of the scene is one pair. A triangle that has found no
  // partner has d = c, and NaN for the second normal: it is met by no ray.
  struct Block {
    LaneArray vertex[4][3];  // [corner][axis]; NaN where there is no triangle
    LaneArray normal[2][3];
    LaneArray largestSlope;  // n . direction that a hit must stay below: 0 culls backs
    LaneArray index[2];      // of the triangles in the scene
  };
  struct Corner;
  struct Met;

  static FloatV edge(const Corner& p, const Corner& q);
  // Inlined always: its vectors then stay in registers.
  [[gnu::always_inline]] static inline Met meet(const Block& block, const RayShear& shear);
  template <bool kCulls>
  static FloatV planeDistance(const Block& block, const FloatV (&n)[3], const Point& origin,
                              const Vector& direction);
  template <bool kCulls>
  static FloatV firstDistance(const Block& block, const Point& origin, const Vector& direction);
  template <bool kCulls>
  static FloatV distance(const Block& block, const Met& met, const Point& origin,
                         const Vector& direction);
  template <bool kCulls>
  bool closestOf(const Ray& ray, float tMax, PrimitiveHit& hit) const;
  template <bool kCulls>
  bool occludedOf(const Point& origin, const Vector& segment) const;

  std::vector<Block> blocks_;
  bool culls_ = false;  // whether any triangle has a front only
};

}  // namespace pathmark
