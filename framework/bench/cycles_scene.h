// writeCyclesScene: a scene as cycles_scene.py reads it.
#pragma once

#include "bench/render_runs.h"

namespace pathmark::bench {

struct CyclesJob {
  std::uint64_t raysPerPixel = 64;
  std::uint64_t seed = 0;
  std::filesystem::path output;  // .exr
};

// Writes `folder`/cycles.json and the arrays that it names: of each material's triangles, three
// floats for a vertex and three 32-bit indices for a triangle. Lengths are the worker's. Phong
// materials have no equal in Cycles: throws UsageError.
std::filesystem::path writeCyclesScene(const BenchScene& scene, const CyclesJob& job,
                                       const std::filesystem::path& folder);

}  // namespace pathmark::bench
