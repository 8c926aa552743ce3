// PathEstimates: the radiance that the path tracer which is checked sees along rays of the judge's
// choice, for judgeMeans.
#pragma once

#include "checks/means.h"

#include <pathmark/types.h>

#include <vector>

namespace pathmark::checks {

struct PathRay {
  Ray ray;
  int bounces;
};

class PathEstimates {
 public:
  // The worker has the scene already. `pathsPerReplicate` a power of two.
  PathEstimates(CheckRun& run, std::vector<PathRay> rays, std::uint32_t pathsPerReplicate)
      : run_(run), rays_(std::move(rays)), paths_(pathsPerReplicate) {}

  // Of each replicate three numbers for each ray, those of its channels. What is no radiance (not
  // finite, or negative) makes them NaN.
  void measure(std::uint32_t first, std::uint32_t count, std::span<double> values);

  std::uint64_t paths() const { return made_; }
  std::uint64_t invalid() const { return invalid_; }

 private:
  CheckRun& run_;
  std::vector<PathRay> rays_;
  std::uint32_t paths_;
  std::uint64_t made_ = 0, invalid_ = 0;
};

}  // namespace pathmark::checks
