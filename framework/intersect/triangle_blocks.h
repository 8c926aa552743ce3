// TriangleBlocks: a ray against all triangles, in pairs that share an edge, a vector of pairs at a
// time. Most pairs are flat quads: a line meets them where it passes all four edges on the same
// side, in one plane. Only the others are taken as two triangles.
//
//   closest    the nearest triangle along a ray
//   occluded   whether any triangle lies on a segment, or on which of a fan
//
// Watertight (Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013): each
// vertex gets the same sheared coordinates in all of its triangles, and the two products of an edge
// function are rounded one by one. Rounding is monotonic, so that the sign of their difference is
// never wrong, only 0 at times, which counts as a hit on both sides: no ray slips through.
#pragma once

#include "intersect/ray_shear.h"
#include "intersect/segment_fan.h"
#include "intersect/simd.h"
#include "render/plan.h"
#include "scene/flat_scene.h"

#include <span>
#include <vector>

namespace pathmark {

class TriangleBlocks {
 public:
  // Of these triangles of the scene.
  TriangleBlocks(const FlatSceneView& scene, std::span<const std::uint32_t> triangles,
                 const FlatTests& tests = {});

  bool empty() const { return blocks_.empty(); }

  // Returns whether the ray meets one at 0 < t < tMax, and only then sets `hit` to the nearest.
  bool closest(const Ray& ray, float tMax, PrimitiveHit& hit) const;

  // Whether a triangle lies on origin + t * segment, 0 < t < 1.
  bool occluded(const Point& origin, const Vector& segment) const;

  // The same of each segment of a fan, to the bit.
  SegmentFan::Mask occluded(const SegmentFan& fan) const;

 private:
  // Triangles a b c and a c d. One that has found no partner is a quad with d = c, whose edge
  // function c d is exactly 0 and changes nothing.
  struct Block {
    LaneArray vertex[4][3];  // [corner][axis]; NaN where there is no triangle
    LaneArray normal[2][3];  // twice the same of a flat pair
    LaneArray largestSlope;  // n . direction that a hit must stay below: 0 culls backs
    LaneArray index[2];      // bits, of the scene's triangles; twice the first of a flat pair
    bool folded;             // whether any pair of it is not flat

    FloatV take(const LaneArray& a) const { return load(a); }
  };
  struct OnePair;
  struct Lines;
  struct Corner;
  struct Met;

  // Pairs are a block, or one of a block's for all lanes. Inlined always: their vectors then stay
  // in registers.
  template <bool kCulls, class Pairs>
  [[gnu::always_inline]] static inline Met meet(const Pairs& pairs, const Lines& line);
  template <bool kCulls, class Pairs>
  [[gnu::always_inline]] static inline FloatV distance(const Pairs& pairs, const Lines& line,
                                                       const Corner& a, const FloatV (&n)[3]);
  template <bool kCulls>
  [[gnu::always_inline]] static inline SegmentFan::Mask crossesPlane(const OnePair& pair,
                                                                     const Lines& lines);
  template <bool kCulls>
  bool closestOf(const Ray& ray, float tMax, PrimitiveHit& hit) const;
  template <bool kCulls>
  bool occludedOf(const Point& origin, const Vector& segment) const;
  template <bool kCulls>
  SegmentFan::Mask occludedOf(const Lines& lines, SegmentFan::Mask lanes) const;
  template <bool kCulls>
  SegmentFan::Mask occludedOf(const SegmentFan& fan) const;

  std::vector<Block> blocks_;
  std::size_t pairs_ = 0;
  bool culls_ = false;  // whether any triangle has a front only
};

}  // namespace pathmark
