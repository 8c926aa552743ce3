// SphereBlocks: a ray against all spheres, a vector of them at a time.
//
//   closest    the nearest sphere along a ray
//   occluded   whether any sphere lies on a segment
//
// The discriminant comes from the distance of the line to the centre, and the smaller root from the
// product of both: neither cancels for far or large spheres (Haines et al., "Precision Improvements
// for Ray/Sphere Intersection", Ray Tracing Gems, chapter 7, 2019).
#pragma once

#include "intersect/simd.h"
#include "render/plan.h"
#include "scene/flat_scene.h"

#include <pathmark/types.h>

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

 private:
  struct Block {
    LaneArray centre[3];  // NaN where there is no sphere
    LaneArray radius;
    LaneArray hideOutside, hideInside;  // 1 for sides through which rays pass
    LaneArray index;
  };
  struct Roots;

  static Roots roots(const Block& block, const Point& origin, const Vector& direction);

  std::vector<Block> blocks_;
};

}  // namespace pathmark
