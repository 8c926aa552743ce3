// FlatIntersector: every ray against every primitive, triangles sixteen at a time.
//
//   closest    the nearest primitive along a ray
//   occluded   whether anything lies on a segment
//
// Triangles are tested watertight (Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection",
// JCGT 2(1), 2013): the edge functions of a shared edge are evaluated from the same numbers, so
// that no ray slips through between two triangles.
#pragma once

#include "intersect/primitive_hit.h"
#include "scene/flat_scene.h"

#include <pathmark/types.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pathmark {

class FlatIntersector {
 public:
  explicit FlatIntersector(const FlatSceneView& scene);

  // Returns whether the ray meets anything at t > 0, and then sets `hit` to the nearest; if not,
  // hit.t becomes infinite.
  bool closest(const Ray& ray, PrimitiveHit& hit) const;

  // Returns whether anything lies on origin + t * segment, 0 < t < 1.
  bool occluded(const Point& origin, const Vector& segment) const;

 private:
  static constexpr int kLanes = 16;

  struct alignas(64) TriangleBlock {
    float vertex[3][3][kLanes];  // [corner][axis][lane]; NaN where there is no triangle
    float smallestArea[kLanes];  // signed projected area a hit must exceed: culls backs
  };

  struct SphereRecord {
    Point centre;
    float radius;
    bool hideOutside, hideInside;  // sides through which rays pass
  };

  struct Shear;

  static void intersectBlock(const TriangleBlock& block, const Shear& shear, float tMin, float tMax,
                             float (&t)[kLanes]);
  static float intersectSphere(const SphereRecord& sphere, const Point& origin,
                               const Vector& direction, float tMax);
  bool nearest(const Ray& ray, const Shear& shear, float tMin, PrimitiveHit& hit) const;
  Vector barycentrics(std::uint32_t triangle, const Shear& shear) const;
  std::array<Float3, 3> corners(std::uint32_t triangle) const;

  std::vector<TriangleBlock> blocks_;
  std::vector<bool> thin_;  // triangles whose hits are asked again in double
  bool anyThin_ = false;
  std::vector<SphereRecord> spheres_;
};

}  // namespace pathmark
