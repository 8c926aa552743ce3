// Means of estimators, as features.
#pragma once

#include "checks/hollow.h"
#include "checks/path_estimates.h"
#include "diagnosis/probes.h"
#include "diagnosis/signature.h"

#include <string>
#include <vector>

namespace pathmark::diagnosis {

struct NamedRay {
  checks::PathRay ray;
  std::string what;
};

// Mean radiance over `scale`, of the channels that are listed.
struct PathQuestion {
  std::vector<NamedRay> rays;
  std::vector<int> channels;
  Colour scale{1.0f};
  std::uint32_t paths = 512;  // of each of the replicates
};

// In the scene that the worker has.
void addPathMeans(const ProbeRun& run, const PathQuestion& question, Signature& signature);

struct FurnaceRays {
  std::vector<int> channels, bounces;
  std::vector<double> cosines;
  const char* words;
};

// Along these rays from within the hollow, over its emission. Gives the worker the scene.
PathQuestion furnaceQuestion(const ProbeRun& run, const checks::Hollow& hollow,
                             checks::Random& random, const Colour& kd, const Colour& emission,
                             const FurnaceRays& rays);

}  // namespace pathmark::diagnosis
