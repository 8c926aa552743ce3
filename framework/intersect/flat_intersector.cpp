#include "intersect/flat_intersector.h"

#include <numeric>

namespace pathmark {

namespace {

std::vector<std::uint32_t> indicesBelow(std::size_t count) {
  std::vector<std::uint32_t> indices(count);
  std::iota(indices.begin(), indices.end(), 0u);
  return indices;
}

}  // namespace

FlatIntersector::FlatIntersector(const FlatSceneView& scene, const FlatTests& tests)
    : FlatIntersector(scene, indicesBelow(scene.triangles.size()),
                      indicesBelow(scene.spheres.size()), tests) {}

}  // namespace pathmark
