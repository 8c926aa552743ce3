// The measurements of bench error.
//
//   ErrorPlan       what to measure
//   ErrorFindings   what came of it
//   measureErrors   does it
#pragma once

#include "bench/error_estimators.h"
#include "bench/error_peers.h"
#include "bench/error_summary.h"

#include <functional>
#include <string>
#include <vector>

namespace pathmark::bench {

struct ErrorPlan {
  std::vector<std::string> scenes;
  std::string with;
  std::vector<AskedEstimator> estimators;
  std::vector<SamplerKind> samplers;
  std::vector<std::uint64_t> raysPerPixel;  // ascending
  std::uint64_t replicates = 8;
  std::uint64_t seed = 0;
  double seconds = 0.0;  // of measuring, shared evenly by the scenes; 0: as long as it takes
  SceneOverrides overrides;
  std::uint64_t referenceRays = 8192;
  std::string referenceFile;
  std::vector<PeerImage> peers;
  bool cycles = false;
};

struct ErrorFindings {
  std::vector<SceneSummary> scenes;
  std::vector<std::string> notes;  // sentences about what was left out
  bool interrupted = false;
  bool fault = false;  // an estimator that was asked for failed
};

// Adds to `runs`, which may hold runs of earlier. `onRun` is called after each new one. Throws
// UsageError, SceneError, ImageError, and CourseworkError if the coursework itself cannot be built.
ErrorFindings measureErrors(const ErrorPlan& plan, ErrorRuns& runs,
                            const std::function<void()>& onRun);

}  // namespace pathmark::bench
