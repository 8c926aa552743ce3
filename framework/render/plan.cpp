#include "render/plan.h"

#include "render/occluders.h"

namespace pathmark {

Plan planFor(const FlatSceneView& scene, ShadowOrigins origins) {
  Plan plan;
  if (scene.triangles.size() >= kFewestForHierarchy)
    plan.triangles = TriangleTest::kHierarchy;
  else if (!scene.triangles.empty())
    plan.triangles = TriangleTest::kFlatLoop;
  const Occluders occluders =
      origins == ShadowOrigins::kSurfaces && plan.triangles != TriangleTest::kHierarchy
          ? occludersOf(scene)
          : allPrimitives(scene);
  plan.occludingTriangles = occluders.triangles;
  plan.occludingSpheres = occluders.spheres;
  return plan;
}

}  // namespace pathmark
