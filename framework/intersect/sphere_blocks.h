// SphereBlocks: a ray against all spheres, a vector of them at a time.
//
//   closest    the nearest sphere along a ray
//   occluded   whether any sphere lies on a segment, or on which of a fan
//
// The discriminant comes from the distance of the line to the centre, and the smaller root from the
// product of both: neither cancels for far or large spheres (Haines et al., "Precision Improvements
// for Ray/Sphere Intersection", Ray Tracing Gems, chapter 7, 2019).
#pragma once

#include "intersect/segment_fan.h"
#include "intersect/simd.h"
#include "render/plan.h"
#include "scene/flat_scene.h"

#include <pathmark/types.h>

#include <array>
#include <span>
#include <vector>

namespace pathmark {

class SphereBlocks {
 public:
  // Of these spheres of the scene.
  SphereBlocks(const FlatSceneView& scene, std::span<const std::uint32_t> spheres,
               const FlatTests& tests = {});

  bool empty() const { return blocks_.empty(); }

  // Returns whether the ray meets one at 0 < t < tMax, and only then sets `hit` to the nearest.
  bool closest(const Ray& ray, float tMax, PrimitiveHit& hit) const;

  // Whether a sphere lies on origin + t * segment, 0 < t < 1.
  bool occluded(const Point& origin, const Vector& segment) const;

  // The same of each segment of a fan, to the bit.
  SegmentFan::Mask occluded(const SegmentFan& fan) const;

 private:
  struct Block {
    LaneArray centre[3];  // NaN where there is no sphere
    LaneArray radius;
    LaneArray hideOutside, hideInside;  // 1 for sides through which rays pass
    LaneArray index;

    FloatV take(const LaneArray& a) const { return load(a); }
  };
  struct OneSphere;
  struct Roots;

  // Spheres are a block, or one of a block's for all lanes; the direction is one for all lanes, or
  // one in each.
  template <class Spheres>
  [[gnu::always_inline]] static inline Roots roots(const Spheres& spheres, const Point& origin,
                                                   const std::array<FloatV, 3>& direction);

  std::vector<Block> blocks_;
  std::size_t spheres_ = 0;
};

}  // namespace pathmark
