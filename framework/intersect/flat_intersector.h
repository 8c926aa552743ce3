// FlatIntersector: every ray against every primitive, as many at a time as the processor's vectors
// have lanes.
//
//   closest    the nearest primitive along a ray
//   occluded   whether anything lies on a segment, or on which of a fan
#pragma once

#include "intersect/sphere_blocks.h"
#include "intersect/triangle_blocks.h"

#include <span>

namespace pathmark {

class FlatIntersector {
 public:
  // Of all of a scene's primitives.
  explicit FlatIntersector(const FlatSceneView& scene, const FlatTests& tests = {});

  // Of these triangles and spheres of a scene.
  FlatIntersector(const FlatSceneView& scene, std::span<const std::uint32_t> triangles,
                  std::span<const std::uint32_t> spheres, const FlatTests& tests = {})
      : triangles_(scene, triangles, tests), spheres_(scene, spheres, tests) {}

  // Returns whether the ray meets anything at 0 < t < tMax, and only then sets `hit` to the
  // nearest.
  bool closest(const Ray& ray, PrimitiveHit& hit, float tMax = kInfinity) const {
    bool met = false;
    if (!triangles_.empty()) met = triangles_.closest(ray, tMax, hit);
    if (!spheres_.empty()) met = spheres_.closest(ray, met ? hit.t : tMax, hit) || met;
    return met;
  }

  // Returns whether anything lies on origin + t * segment, 0 < t < 1.
  bool occluded(const Point& origin, const Vector& segment) const {
    return (!spheres_.empty() && spheres_.occluded(origin, segment)) ||
           (!triangles_.empty() && triangles_.occluded(origin, segment));
  }

  // The same of each segment of a fan, to the bit.
  SegmentFan::Mask occluded(const SegmentFan& fan) const {
    const SegmentFan::Mask bySpheres = spheres_.occluded(fan);
    return bySpheres || triangles_.occluded({fan.origin, fan.way, fan.lanes && !bySpheres});
  }

 private:
  TriangleBlocks triangles_;
  SphereBlocks spheres_;
};

}  // namespace pathmark
