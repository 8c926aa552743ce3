// RawEmbree: Embree's own single-ray calls with as little around them as can be, in its fastest
// setting, which is not watertight. What our own code is measured against.
#pragma once

#include "intersect/primitive_hit.h"
#include "scene/flat_scene.h"

#include <pathmark/types.h>

#include <memory>

struct RTCDeviceTy;
struct RTCSceneTy;

namespace pathmark::bench {

class RawEmbree {
 public:
  // Triangles only. The memory behind the view must outlive this object.
  explicit RawEmbree(const FlatSceneView& scene);

  bool closest(const Ray& ray, PrimitiveHit& hit) const;
  bool occluded(const Point& origin, const Vector& segment) const;

 private:
  struct Release {
    void operator()(RTCDeviceTy* device) const;
    void operator()(RTCSceneTy* scene) const;
  };

  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::unique_ptr<RTCSceneTy, Release> scene_;
};

}  // namespace pathmark::bench
