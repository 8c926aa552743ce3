#include "intersect/quad_mesh.h"

#include <optional>

namespace pathmark {

namespace {

using Vertices = std::array<std::uint32_t, 3>;

// The quad of two triangles if they share an edge that they run along in opposite directions.
// Vertices at the same place are the same vertex.
std::optional<QuadMesh::Quad> join(const FlatSceneView& scene, const Vertices& a,
                                   const Vertices& b) {
  const auto same = [&](std::uint32_t i, std::uint32_t k) {
    return i == k || scene.vertices[i] == scene.vertices[k];
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t from = a[i], to = a[(i + 1) % 3];
    for (std::size_t k = 0; k < 3; ++k)
      if (same(b[k], to) && same(b[(k + 1) % 3], from))
        return QuadMesh::Quad{a[(i + 2) % 3], from, b[(k + 2) % 3], to};
  }
  return std::nullopt;
}

template <class Visit>
void forEachQuad(const FlatSceneView& scene, Visit visit) {
  const auto count = static_cast<std::uint32_t>(scene.triangles.size());
  for (std::uint32_t t = 0; t < count;) {
    const Vertices& a = scene.triangles[t].vertex;
    const auto pair = t + 1 < count ? join(scene, a, scene.triangles[t + 1].vertex) : std::nullopt;
    visit(pair.value_or(QuadMesh::Quad{a[0], a[1], a[2], a[2]}), t, pair.has_value());
    t += pair ? 2 : 1;
  }
}

}  // namespace

std::size_t countQuads(const FlatSceneView& scene) {
  std::size_t count = 0;
  forEachQuad(scene, [&](const auto&, std::uint32_t, bool) { ++count; });
  return count;
}

QuadMesh::QuadMesh(const FlatSceneView& scene) {
  const std::size_t count = countQuads(scene);
  quads_.reserve(count);
  runs_.reserve((count + kRun - 1) / kRun);
  forEachQuad(scene, [&](const Quad& quad, std::uint32_t firstTriangle, bool pair) {
    add(quad, firstTriangle, pair);
  });
}

void QuadMesh::add(const Quad& quad, std::uint32_t firstTriangle, bool pair) {
  const std::size_t place = quads_.size() % kRun;
  if (place == 0) runs_.push_back({0, firstTriangle});
  if (pair) runs_.back().pairs |= std::uint64_t{1} << place;
  quads_.push_back(quad);
}

}  // namespace pathmark
