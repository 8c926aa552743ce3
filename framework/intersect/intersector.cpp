#include "intersect/intersector.h"

namespace pathmark {

namespace {

FlatSceneView flatPart(const FlatSceneView& scene) {
  FlatSceneView part = scene;
  if (scene.triangles.size() > Intersector::kMostFlatTriangles) part.triangles = {};
  return part;
}

}  // namespace

Intersector::Intersector(const FlatSceneView& scene) : flat_(flatPart(scene)) {
  if (scene.triangles.size() > kMostFlatTriangles) embree_.emplace(scene);
}

}  // namespace pathmark
