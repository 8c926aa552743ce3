#include "render/plan.h"

#include "intersect/triangle_pairs.h"
#include "render/occluders.h"

#include <numeric>
#include <utility>

namespace pathmark {

namespace {

Occluders occludersFor(const FlatSceneView& scene, TriangleTest test, ShadowOrigins origins) {
  if (test == TriangleTest::kHierarchy) {
    FlatSceneView rest = scene;
    rest.triangles = {};
    return allPrimitives(rest);
  }
  return origins == ShadowOrigins::kSurfaces ? occludersOf(scene) : allPrimitives(scene);
}

// The loop takes a step for so many pairs, and as long for a triangle that is alone.
bool hasManyTriangles(const FlatSceneView& scene, bool inPairs) {
  const std::size_t triangles = scene.triangles.size();
  if (!inPairs || triangles < kFewestForHierarchy || triangles >= 2 * kFewestForHierarchy)
    return triangles >= kFewestForHierarchy;
  std::vector<std::uint32_t> all(triangles);
  std::iota(all.begin(), all.end(), 0u);
  return pairTriangles(scene, all).size() >= kFewestForHierarchy;
}

}  // namespace

Plan planFor(const FlatSceneView& scene, ShadowOrigins origins, Skips skips) {
  Plan plan;
  plan.flatTests = {.pairs = skips.has(Skip::kSecondTriangles),
                    .backsOfAll = !skips.has(Skip::kBackTests),
                    .kindsOfNothing = !skips.has(Skip::kEmptyKinds)};
  const bool many = hasManyTriangles(scene, skips.has(Skip::kSecondTriangles));
  if (!scene.triangles.empty() &&
      (many ? skips.has(Skip::kLoopOverMany) : !skips.has(Skip::kHierarchyOfFew)))
    plan.triangles = TriangleTest::kHierarchy;
  else if (!scene.triangles.empty())
    plan.triangles = TriangleTest::kFlatLoop;
  plan.cameraRaysTogether =
      plan.triangles == TriangleTest::kHierarchy && skips.has(Skip::kSingleCameraRays);
  if (!skips.has(Skip::kBoundingSurfaces)) origins = ShadowOrigins::kAnywhere;
  Occluders occluders = occludersFor(scene, plan.triangles, origins);
  plan.occludingTriangles = std::move(occluders.triangles);
  plan.occludingSpheres = std::move(occluders.spheres);
  return plan;
}

}  // namespace pathmark
