#include "intersect/intersector.h"

namespace pathmark {

namespace {

// Where both take the same time to render a scene. The flat loop grows with every sixteen
// triangles.
constexpr std::size_t kMostFlatTriangles = 32;

FlatSceneView flatPart(const FlatSceneView& scene) {
  FlatSceneView part = scene;
  if (scene.triangles.size() > kMostFlatTriangles) part.triangles = {};
  return part;
}

}  // namespace

Intersector::Intersector(const FlatSceneView& scene) : flat_(flatPart(scene)) {
  if (scene.triangles.size() > kMostFlatTriangles) embree_.emplace(scene);
}

}  // namespace pathmark
