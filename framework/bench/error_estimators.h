// The estimators that bench error compares: a coursework, and its labs.
//
//   AskedEstimator    by what name, from which folder
//   findEstimators    those of a command line
//   RunningEstimator  a worker with one of them and a scene, and what its renders cost
#pragma once

#include "bench/render_way.h"
#include "host/session.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pathmark::bench {

struct AskedEstimator {
  std::string name;
  std::filesystem::path folder;
  bool byName = false;  // by a person: it must be usable
  RenderWay way{};
};

// Each word is the name of the coursework `with` itself, of one of its labs, or NAME=FOLDER, and
// may end with the words of a RenderWay. Without words, the coursework and all its labs. Throws
// UsageError.
std::vector<AskedEstimator> findEstimators(const std::string& with,
                                           const std::vector<std::string>& words);

struct EstimatorRender {
  Image image;
  double cpuSeconds = 0.0;  // of the worker, for this render alone
};

class RunningEstimator {
 public:
  // Throws WorkerError.
  RunningEstimator(const Coursework& coursework, const RenderWay& way, const LoadedScene& scene);

  // With one thread. Nothing if it was interrupted. Throws WorkerError, also for values that are no
  // radiance.
  std::optional<EstimatorRender> render(std::uint64_t raysPerPixel, SamplerKind sampler,
                                        std::uint64_t seed);

 private:
  const LoadedScene& scene_;
  RenderWay way_;
  std::unique_ptr<WorkerProcess> worker_;
};

// A sentence about functions without which the estimator makes no picture; empty if there are none.
std::string whatIsUnwritten(const Coursework& coursework, const RenderWay& way);

}  // namespace pathmark::bench
