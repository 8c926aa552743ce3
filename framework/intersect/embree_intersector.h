// EmbreeIntersector: rays against many triangles, by Embree's bounding volume hierarchy.
//
//   closest    the nearest triangle along a ray, or along each of a packet
//   occluded   whether any triangle lies on a segment, or on which of a fan
//
// In Embree's robust mode, so that no ray slips through the shared edge of two triangles. Either of
// Embree 3 and 4 serves.
#pragma once

#include "intersect/primitive_hit.h"
#include "intersect/quad_mesh.h"
#include "intersect/segment_fan.h"
#include "scene/flat_scene.h"

#include <pathmark/types.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

struct RTCDeviceTy;
struct RTCSceneTy;

namespace pathmark {

inline constexpr std::size_t kMostInPacket = 16;

class EmbreeIntersector {
 public:
  // What Embree's rounding errors depend on.
  struct Scale {
    float size;         // of the scene
    float heightError;  // of points' heights above a triangle's plane
  };

  // What Embree is told to look at when it asks about a hit.
  struct Scene {
    FlatSceneView view;
    std::optional<QuadMesh> quads;  // where most triangles are in pairs
    Scale scale;
  };

  // Spheres are left out. The memory behind the view must outlive the intersector.
  explicit EmbreeIntersector(const FlatSceneView& scene);
  ~EmbreeIntersector();

  // Returns whether the ray meets a triangle at 0 < t < tMax, and only then sets `hit`.
  bool closest(const Ray& ray, float tMax, PrimitiveHit& hit) const;

  // How many rays that lie near each other are met together faster than one by one; 1: none.
  std::size_t packetSize() const { return packetSize_; }

  // The same of each of at most packetSize() rays and their tMax: bit i of what it returns says
  // whether ray i meets a triangle. A ray that grazes an edge may meet another one than by itself.
  std::uint32_t closest(std::span<const Ray> rays, std::span<const float> tMax,
                        std::span<PrimitiveHit> hits) const;

  // Returns whether a triangle lies on origin + t * segment, 0 < t < 1.
  bool occluded(const Point& origin, const Vector& segment) const;

  // The same of each segment of a fan.
  SegmentFan::Mask occluded(const SegmentFan& fan) const;

 private:
  template <class Packet>
  std::uint32_t closestOfPacket(std::span<const Ray> rays, std::span<const float> tMax,
                                std::span<PrimitiveHit> hits) const;

  struct Release {
    void operator()(RTCDeviceTy* device) const;
    void operator()(RTCSceneTy* scene) const;
  };

  std::unique_ptr<const Scene> triangles_;  // at one address, which Embree is told
  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::unique_ptr<RTCSceneTy, Release> scene_;
  std::size_t packetSize_ = 1;
};

// Embree and its task scheduler look at the machine when they are first used: at its processors,
// the stack, and libraries that might be there. Afterwards a scene needs nothing but memory and
// threads.
void warmUpEmbree();

}  // namespace pathmark
