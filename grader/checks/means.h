// Means: statistics over randomised replicates, judged together and in stages.
//
//   Mean          what is measured, and what it must be
//   judgeMeans    measures and judges
//
// alpha is that of the error budget for each mean; an error of `delta` passes with probability at
// most 0.001. Most functions are decided at the first look, clearly right or clearly wrong.
#pragma once

#include "checks/check.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace pathmark::checks {

struct Mean {
  std::string what;  // "mean of cos(theta)"
  double expected = 0.0;

  // Errors, relative to `scale`: accepted as rounding, and found with probability 0.999.
  double tolerance = 2e-4, delta = 0.01;
  double scale = 1.0;  // typical size of the value: 1 for a weight or a cosine

  double expectedError = 0.0;  // standard error of `expected`, where that has been measured
  double skewness = 0.5;       // of a replicate of correct functions, at most
};

// A mistake with the means that it would give, one for each Mean.
struct Suspicion {
  std::string mistake;
  std::vector<double> means;
};

// Looks at 256, 1024 and 4096 replicates.
inline constexpr std::uint32_t kReplicatesOfLook[] = {256, 1024, 4096};

// Writes the means of these replicates, one after the other, means.size() numbers each.
using Measure = std::function<void(std::uint32_t first, std::uint32_t count, std::span<double>)>;

// `where`: what was measured with which inputs. The finding of the worst mean, or of the first that
// fails: plain ones come first.
Finding judgeMeans(CheckRun& run, const std::vector<Mean>& means, const Measure& measure,
                   const std::string& where, const std::vector<Suspicion>& suspicions = {},
                   int looks = 2);

}  // namespace pathmark::checks
