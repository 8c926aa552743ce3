// Intersector: the way to meet a scene's primitives that its plan has chosen.
//
//   closest    the nearest primitive along a ray, or along each of a packet
//   occluded   whether anything lies on a segment between two points that shadow rays may have, or
//              on which of a fan
#pragma once

#include "intersect/embree_intersector.h"
#include "intersect/flat_intersector.h"
#include "render/plan.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace pathmark {

class Intersector {
 public:
  // The memory behind the view must outlive the intersector.
  Intersector(const FlatSceneView& scene, const Plan& plan);

  // Returns whether the ray meets anything at t > 0, and only then sets `hit` to the nearest.
  bool closest(const Ray& ray, PrimitiveHit& hit) const {
    const bool met = flat_.closest(ray, hit);
    if (!hierarchy_) return met;
    return hierarchy_->closest(ray, met ? hit.t : kInfinity, hit) || met;
  }

  // How many camera rays are met together; 1: they are met one by one.
  std::size_t packetSize() const { return packetSize_; }

  // The same of each of at most packetSize() rays: bit i of what it returns is of ray i.
  std::uint32_t closest(std::span<const Ray> rays, std::span<PrimitiveHit> hits) const;

  // Returns whether anything lies on origin + t * segment, 0 < t < 1.
  bool occluded(const Point& origin, const Vector& segment) const {
    return occluders_.occluded(origin, segment) ||
           (hierarchy_ && hierarchy_->occluded(origin, segment));
  }

  // Whether there is anything that hides one end of a segment from the other, but not the other
  // way round.
  bool hidesOneWay() const { return hidesOneWay_; }

  // The same of each segment of a fan.
  SegmentFan::Mask occluded(const SegmentFan& fan) const {
    const SegmentFan::Mask occluded = occluders_.occluded(fan);
    if (!hierarchy_) return occluded;
    return occluded || hierarchy_->occluded({fan.origin, fan.way, fan.lanes && !occluded});
  }

 private:
  FlatIntersector flat_, occluders_;  // without the triangles that are in the hierarchy
  std::optional<EmbreeIntersector> hierarchy_;
  std::size_t packetSize_ = 1;
  bool hidesOneWay_;
};

}  // namespace pathmark
