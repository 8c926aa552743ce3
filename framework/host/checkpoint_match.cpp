// Which checkpoints a render can go on from.
#include "host/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace pathmark {

namespace {

std::string nameOfEstimator(const RenderSettings& settings) {
  switch (settings.estimator) {
    case Estimator::kWarmUp:
      return "with --warm-up";
    case Estimator::kMis:
      return "with --mis";
    case Estimator::kReuse:
      return fmt::format("with --reuse {} --direct-paths {}", settings.sharing.pixels,
                         settings.sharing.directPaths);
    case Estimator::kSplit:
      return fmt::format("with --split {}{}", settings.sharing.pathsPerRay,
                         settings.sharing.directLight != 0 ? " --share-direct" : "");
    case Estimator::kPath:
      break;
  }
  return "by tracePath";
}

std::string nameOf(const std::string& paths) { return paths.empty() ? "of all light" : paths; }

std::string differentSettings(const CheckpointIdentity& has, const CheckpointIdentity& wanted) {
  const RenderSettings &a = has.settings, &b = wanted.settings;
  if (a.width != b.width || a.height != b.height)
    return fmt::format("its size is {}x{}, not {}x{}", a.width, a.height, b.width, b.height);
  if (has.maxBounces != wanted.maxBounces)
    return fmt::format("its paths have up to {} bounces, not {}", has.maxBounces,
                       wanted.maxBounces);
  if (a.seed != b.seed) return fmt::format("its seed is {}, not {}", a.seed, b.seed);
  if (a.sampler != b.sampler)
    return fmt::format("its sampler is {}, not {}", nameOf(a.sampler), nameOf(b.sampler));
  if (const std::string made = nameOfEstimator(a), asked = nameOfEstimator(b); made != asked)
    return fmt::format("it was made {}, not {}", made, asked);
  if (a.paths != b.paths)
    return fmt::format("its light paths are {}, not {}", nameOf(a.paths), nameOf(b.paths));
  if (has.scene != wanted.scene) return "it is of another scene, or the scene has changed since";
  if (has.coursework != wanted.coursework)
    return "it was made with other coursework, or the coursework has changed since";
  return {};
}

// Every replicate has its own random numbers, and every pass its own strata: only whole passes of
// the same number of rays, in replicates of the same number of rays, are also those of a larger
// image.
std::string differentRays(const Checkpoint& checkpoint, const RenderSettings& wanted) {
  const RenderSettings& has = checkpoint.identity.settings;
  const RenderState& state = checkpoint.state;
  const bool several = has.replicates > 1;
  if (several != (wanted.replicates > 1) ||
      (several && has.raysPerReplicate() != wanted.raysPerReplicate()))
    return fmt::format("its replicates are {} of {} rays per pixel, not {} of {}", has.replicates,
                       has.raysPerReplicate(), wanted.replicates, wanted.raysPerReplicate());
  if (has.raysPerPass() != wanted.raysPerPass())
    return fmt::format("its passes have {} rays per pixel, not {}", has.raysPerPass(),
                       wanted.raysPerPass());
  const std::uint64_t pass = has.raysPerPass(), each = has.raysPerReplicate();
  const std::uint64_t begun = state.row > 0 ? std::min(pass, each - state.firstRay) : 0;
  const std::uint64_t rays = state.replicate * each + state.firstRay + begun;
  if (rays > wanted.raysPerPixel)
    return fmt::format("it has {} rays per pixel already, and {} are wanted", rays,
                       wanted.raysPerPixel);
  if (!several && rays % pass != 0 && rays != wanted.raysPerPixel)
    return fmt::format(
        "its last pass has {} rays per pixel, and belongs to a picture of {} only; with a multiple "
        "of {} it could be refined",
        rays % pass, rays, pass);
  return {};
}

}  // namespace

std::string whyNotContinued(const Checkpoint& checkpoint, const CheckpointIdentity& wanted) {
  std::string why = differentSettings(checkpoint.identity, wanted);
  return why.empty() ? differentRays(checkpoint, wanted.settings) : why;
}

bool holds(const RenderState& a, const RenderState& b) {
  return std::tie(a.replicate, a.firstRay, a.row) >= std::tie(b.replicate, b.firstRay, b.row);
}

}  // namespace pathmark
