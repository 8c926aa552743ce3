#include "intersect/intersector.h"

#include <algorithm>
#include <array>
#include <vector>

namespace pathmark {

namespace {

FlatSceneView flatPart(const FlatSceneView& scene, const Plan& plan) {
  FlatSceneView part = scene;
  if (plan.triangles == TriangleTest::kHierarchy) part.triangles = {};
  return part;
}

template <class Primitive>
bool anyFrontOnly(const FlatSceneView& scene, std::span<const Primitive> primitives,
                  const std::vector<std::uint32_t>& which) {
  return std::any_of(which.begin(), which.end(), [&](std::uint32_t i) {
    return scene.shapes[primitives[i].shape].frontOnly != 0;
  });
}

}  // namespace

Intersector::Intersector(const FlatSceneView& scene, const Plan& plan)
    : flat_(flatPart(scene, plan), plan.flatTests),
      occluders_(scene, plan.occludingTriangles, plan.occludingSpheres, plan.flatTests),
      hidesOneWay_(anyFrontOnly(scene, scene.triangles, plan.occludingTriangles) ||
                   anyFrontOnly(scene, scene.spheres, plan.occludingSpheres) ||
                   (plan.triangles == TriangleTest::kHierarchy && scene.anyFrontOnly())) {
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
