// Intersector: the way to meet a scene's primitives that suits their number.
//
//   closest    the nearest primitive along a ray
//   occluded   whether anything lies on a segment
//
// Few triangles are fastest tested one and all, many in a hierarchy. Spheres are tested one and
// all.
#pragma once

#include "intersect/embree_intersector.h"
#include "intersect/flat_intersector.h"

#include <cstddef>
#include <optional>

namespace pathmark {

class Intersector {
 public:
  // Where both take the same time to render a scene. The flat loop grows with every sixteen
  // triangles.
  static constexpr std::size_t kMostFlatTriangles = 32;

  // The memory behind the view must outlive the intersector.
  explicit Intersector(const FlatSceneView& scene);

  // Returns whether the ray meets anything at t > 0, and then sets `hit` to the nearest.
  bool closest(const Ray& ray, PrimitiveHit& hit) const {
    const bool met = flat_.closest(ray, hit);
    return embree_ ? embree_->closest(ray, hit.t, hit) || met : met;
  }

  // Returns whether anything lies on origin + t * segment, 0 < t < 1.
  bool occluded(const Point& origin, const Vector& segment) const {
    return flat_.occluded(origin, segment) || (embree_ && embree_->occluded(origin, segment));
  }

 private:
  FlatIntersector flat_;  // of spheres, and of triangles where there are few
  std::optional<EmbreeIntersector> embree_;
};

}  // namespace pathmark
