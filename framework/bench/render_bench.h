// What the parts of bench render share.
//
//   RenderPlan    how much of each is measured
//   RenderBench   the scenes, what renders them, and where the findings go
//   measureEfficiency, measureGrowth, measureThreads, measureStart, measureMemoryUse   the parts
#pragma once

#include "bench/cycles_peer.h"
#include "bench/progress.h"
#include "bench/render_runs.h"
#include "bench/report.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace pathmark::bench {

struct RenderPlan {
  std::uint64_t fewRays = 64, manyRays = 256;  // through each pixel
  int seeds = 3;
  int repeats = 9;          // of what takes less than a second
  double raySeconds = 0.3;  // for each look at the raw rate of rays
};

struct RenderBench {
  RenderPlan plan;
  RenderRuns runs;
  std::vector<BenchScene> scenes;
  std::optional<CyclesPeer> cycles;
  Progress progress;
  Report report;

  // Nothing if the scene is left out of this run.
  const BenchScene* find(std::string_view key) const;
  void add(Figure figure) { report.figures.push_back(std::move(figure)); }
};

// Image error per CPU second, the image's mean, camera paths and rays per CPU second against the
// raw rates of the intersectors, and all that against Cycles.
void measureEfficiency(RenderBench& bench);

// What a ray costs with a thousand times as many triangles.
void measureGrowth(RenderBench& bench);

// Two threads against one, and whether their images have the same bits.
void measureThreads(RenderBench& bench);

// From the start of the program to its end, with one tile of one ray per pixel.
void measureStart(RenderBench& bench);

// Beyond what the program needs for one triangle in one pixel, and whether it grows with the rays.
void measureMemoryUse(RenderBench& bench);

}  // namespace pathmark::bench
