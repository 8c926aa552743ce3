// QuadMesh: a scene's triangles two by two, so that a hierarchy over them is half as large.
//
//   quads        each of four vertices
//   firstOf      which triangle a quad's first half is
//   isPair       whether its second half is the triangle after that, or nothing
//   countQuads   how many there would be
#pragma once

#include "scene/flat_scene.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pathmark {

// A quad a b c d is the triangles a b d and c d b, with the orientation that they have in the
// scene; in a triangle that is alone, d = c. Only triangles that follow each other are paired:
// meshes are mostly stored in rows or strips, or have been quads, and pairs of this kind are found
// at once and need a bit each.
class QuadMesh {
 public:
  using Quad = std::array<std::uint32_t, 4>;

  explicit QuadMesh(const FlatSceneView& scene);

  const std::vector<Quad>& quads() const { return quads_; }

  std::uint32_t firstOf(std::uint32_t quad) const {
    const Run& run = runs_[quad / kRun];
    const std::uint64_t before = (std::uint64_t{1} << (quad % kRun)) - 1;
    return run.firstTriangle + quad % kRun +
           static_cast<std::uint32_t>(std::popcount(run.pairs & before));
  }

  bool isPair(std::uint32_t quad) const {
    return ((runs_[quad / kRun].pairs >> (quad % kRun)) & 1) != 0;
  }

 private:
  static constexpr std::uint32_t kRun = 64;

  // Quads that follow each other.
  struct Run {
    std::uint64_t pairs = 0;  // a bit for each quad
    std::uint32_t firstTriangle = 0;
  };

  void add(const Quad& quad, std::uint32_t firstTriangle, bool pair);

  std::vector<Quad> quads_;
  std::vector<Run> runs_;
};

std::size_t countQuads(const FlatSceneView& scene);

}  // namespace pathmark
