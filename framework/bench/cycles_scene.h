// writeCyclesScene: a scene as cycles_scene.py reads it.
#pragma once

#include "bench/render_runs.h"

namespace pathmark::bench {

// Every point is moved by `shift` along each axis, and then multiplied by `scale`, in Blender.
struct CyclesPlace {
  double scale = 1.0, shift = 0.0;
};

struct CyclesJob {
  std::uint64_t raysPerPixel = 64;
  std::uint64_t seed = 0;
  std::filesystem::path output;  // .exr
  CyclesPlace place{};
};

// Writes `folder`/cycles.json and the arrays that it names: of each material's triangles, three
// floats for a vertex and three 32-bit indices for a triangle. Lengths are the worker's. Phong
// materials have no equal in Cycles: throws UsageError.
std::filesystem::path writeCyclesScene(const BenchScene& scene, const CyclesJob& job,
                                       const std::filesystem::path& folder);

}  // namespace pathmark::bench
