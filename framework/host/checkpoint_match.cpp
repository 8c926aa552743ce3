// Which checkpoints a render can go on from, and with what options.
#include "host/checkpoint.h"
#include "scene/limits.h"

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

// The most that the command line takes.
constexpr std::uint64_t kMostReplicates = 1024;

std::uint64_t wholePass() { return raysPerPass(kMostRaysPerPixel); }

std::string optionsOf(std::uint64_t raysPerReplicate, std::uint64_t replicates) {
  return replicates == 1 ? fmt::format("--rays-per-pixel {}", raysPerReplicate)
                         : fmt::format("--rays-per-pixel {} --replicates {}",
                                       raysPerReplicate * replicates, replicates);
}

// Options that a complete picture can be refined with; empty if there are none.
std::string refiningOptions(const RenderSettings& made) {
  const std::uint64_t each = made.raysPerReplicate();
  if (made.replicates == 1)
    return each % wholePass() == 0 && 2 * each <= kMostRaysPerPixel ? optionsOf(2 * each, 1) : "";
  const std::uint64_t more = std::min(std::uint64_t{2} * made.replicates, kMostReplicates);
  return more > made.replicates && each * more <= kMostRaysPerPixel ? optionsOf(each, more) : "";
}

// What a render can go on from the checkpoint with: with as many replicates as are wanted, if that
// is possible.
std::string whatGoesOn(const Checkpoint& checkpoint, const RenderSettings& wanted) {
  const RenderSettings& has = checkpoint.identity.settings;
  const std::uint64_t each = has.raysPerReplicate();
  const bool complete = finished(has, checkpoint.state);
  std::string options = complete ? refiningOptions(has) : optionsOf(each, has.replicates);
  if (has.replicates > 1 && wanted.replicates > has.replicates &&
      each * wanted.replicates <= kMostRaysPerPixel)
    options = optionsOf(each, wanted.replicates);
  if (options.empty()) return "it is complete, and cannot be refined";
  if (has.replicates == 1 && wanted.replicates > 1) options += " and without --replicates";
  return fmt::format("with {} it could go on", options);
}

// Every replicate has its own random numbers, and every pass its own strata: only whole passes of
// the same number of rays, in replicates of the same number of rays, are also those of a larger
// image.
std::string differentRays(const Checkpoint& checkpoint, const RenderSettings& wanted) {
  const RenderSettings& has = checkpoint.identity.settings;
  const RenderState& state = checkpoint.state;
  const bool several = has.replicates > 1;
  const std::string works = whatGoesOn(checkpoint, wanted);
  if (several != (wanted.replicates > 1) ||
      (several && has.raysPerReplicate() != wanted.raysPerReplicate()))
    return fmt::format("its replicates are {} of {} rays per pixel, not {} of {}; {}",
                       has.replicates, has.raysPerReplicate(), wanted.replicates,
                       wanted.raysPerReplicate(), works);
  if (has.raysPerPass() != wanted.raysPerPass())
    return fmt::format("its passes have {} rays per pixel, not {}; {}", has.raysPerPass(),
                       wanted.raysPerPass(), works);
  const std::uint64_t pass = has.raysPerPass(), each = has.raysPerReplicate();
  const std::uint64_t begun = state.row > 0 ? std::min(pass, each - state.firstRay) : 0;
  const std::uint64_t rays = state.replicate * each + state.firstRay + begun;
  if (rays > wanted.raysPerPixel)
    return fmt::format("it has {} rays per pixel already, and {} are wanted; {}", rays,
                       wanted.raysPerPixel, works);
  if (!several && rays % pass != 0 && rays != wanted.raysPerPixel)
    return fmt::format(
        "its last pass has {0} rays per pixel, and belongs to a picture of {1} only; one of a "
        "multiple of {2} rays per pixel, such as {3}, could be refined",
        rays % pass, rays, pass, (rays / pass + 1) * pass);
  return {};
}

}  // namespace

std::string whyNotContinued(const Checkpoint& checkpoint, const CheckpointIdentity& wanted) {
  std::string why = differentSettings(checkpoint.identity, wanted);
  return why.empty() ? differentRays(checkpoint, wanted.settings) : why;
}

std::string howToRefine(const RenderSettings& made) {
  const std::uint64_t pass = wholePass(), rays = made.raysPerPixel;
  if (made.replicates == 1 && rays % pass != 0)
    return fmt::format(
        "The picture cannot be refined: only whole passes of {} rays per pixel are gone on from, "
        "and its last has {}; with --rays-per-pixel {} it could be.",
        pass, rays % pass, (rays / pass + 1) * pass);
  const std::string options = refiningOptions(made);
  if (options.empty())
    return fmt::format(
        "The picture cannot be refined: a render has at most {} rays per pixel and {} replicates.",
        kMostRaysPerPixel, kMostReplicates);
  return fmt::format("To refine the picture: --resume with more {}, such as {}.",
                     made.replicates == 1
                         ? "rays per pixel"
                         : fmt::format("replicates of {} rays per pixel", made.raysPerReplicate()),
                     options);
}

bool holds(const RenderState& a, const RenderState& b) {
  return std::tie(a.replicate, a.firstRay, a.row) >= std::tie(b.replicate, b.firstRay, b.row);
}

}  // namespace pathmark
