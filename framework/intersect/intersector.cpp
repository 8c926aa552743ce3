#include "intersect/intersector.h"

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
}

}  // namespace pathmark
