#include "intersect/intersector.h"

#include <array>

namespace pathmark {

namespace {

FlatSceneView flatPart(const FlatSceneView& scene, const Plan& plan) {
  FlatSceneView part = scene;
  if (plan.triangles == TriangleTest::kHierarchy) part.triangles = {};
  return part;
}

}  // namespace

Intersector::Intersector(const FlatSceneView& scene, const Plan& plan)
    : flat_(flatPart(scene, plan), plan.flatTests),
      occluders_(scene, plan.occludingTriangles, plan.occludingSpheres, plan.flatTests) {
  if (plan.triangles == TriangleTest::kHierarchy) hierarchy_.emplace(scene);
  if (hierarchy_ && plan.cameraRaysTogether) packetSize_ = hierarchy_->packetSize();
}

std::uint32_t Intersector::closest(std::span<const Ray> rays, std::span<PrimitiveHit> hits) const {
  std::uint32_t met = 0;
  std::array<float, kMostInPacket> tMax;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool here = flat_.closest(rays[i], hits[i]);
    tMax[i] = here ? hits[i].t : kInfinity;
    if (here) met |= 1u << i;
  }
  if (!hierarchy_) return met;
  return met | hierarchy_->closest(rays, std::span(tMax).first(rays.size()), hits);
}

}  // namespace pathmark
