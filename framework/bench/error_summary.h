// What the runs of bench error say together.
//
//   PointSummary    one scene, estimator, sampler and number of rays: mean error, time, efficiency
//   CurveSummary    its points, and how the error falls with time
//   SceneSummary    all curves of a scene, and its reference's own error
//   summarise       makes them
#pragma once

#include "bench/error_runs.h"
#include "bench/error_statistics.h"

#include <string>
#include <vector>

namespace pathmark::bench {

struct PointSummary {
  std::uint64_t raysPerPixel = 0;
  std::size_t replicates = 0;
  Interval cpuSeconds, mse, relativeMse;
  Interval efficiency;  // 1 / (relative MSE x CPU seconds)
  Interval worstShare;
  Interval mean;  // of the image, relative to the reference's

  // Whether the error stands out of the reference's own.
  bool isMeasured() const { return relativeMse.value > 0.0; }
};

struct CurveSummary {
  std::string estimator, sampler;
  std::vector<PointSummary> points;  // by their numbers of rays
  Interval slope;  // of log(relative MSE) against log(CPU seconds), -1 for independent samples

  std::string name() const;
};

struct SceneSummary {
  std::string scene;
  OwnDeviation reference;
  std::vector<CurveSummary> curves;  // in the order of the runs
};

// Of the runs of this scene.
SceneSummary summarise(const std::string& scene, const OwnDeviation& reference,
                       const std::vector<ErrorRun>& runs);

}  // namespace pathmark::bench
