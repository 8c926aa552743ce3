// RenderPair: the same render made by two workers in turn, to compare their times and pictures.
#pragma once

#include "bench/stress/block_difference.h"
#include "host/session.h"
#include "render/skips.h"

#include <optional>
#include <vector>

namespace pathmark::bench {

struct RenderSide {
  Coursework coursework;
  Skips skips{};
  std::vector<std::uint64_t> tileRays{};  // empty: all tiles have the same rays
};

struct PairResult {
  double ratio = 1.0;            // CPU time of the second over that of the first: the median
  double low = 1.0, high = 1.0;  // quartiles of the rounds
  std::size_t differing = 0;     // values of the pictures that have other bits
  BlockDifference difference;    // of the pictures, with the same random numbers
};

struct PairPlan {
  std::uint64_t rays = 64;  // of each pixel of a render
  int rounds = 15;
};

// Each side renders once to warm up, and its picture is kept; then they take turns. Throws
// Interrupted on Ctrl-C, and WorkerError.
PairResult renderInTurn(const LoadedScene& scene, const RenderSide& first, const RenderSide& second,
                        const PairPlan& plan);

}  // namespace pathmark::bench
