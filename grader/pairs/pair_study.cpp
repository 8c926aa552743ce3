#include "pairs/pair_study.h"

#include "checks/runner.h"
#include "film/compare.h"
#include "film/contact_sheet.h"
#include "host/coursework_builder.h"
#include "host/session.h"
#include "marking/pictures.h"
#include "sampling/mix.h"
#include "scene/load_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <thread>

namespace pathmark::pairs {

namespace fs = std::filesystem;

namespace {

constexpr int kPixels = 96;  // along the longer side

marking::MarkingScene sceneOf(const Pair& pair) {
  const fs::path file = shippedSceneFile(pair.scene);
  const FlatCamera camera = loadScene(file).flat.camera;
  SceneOverrides overrides;
  overrides.size =
      thumbnailSize(static_cast<int>(camera.width), static_cast<int>(camera.height), kPixels);
  overrides.maxBounces = pair.maxBounces;
  const LoadedScene loaded = loadScene(file, overrides);
  return {sceneWords(pair), loaded.flat, pair.warmUp ? Estimator::kWarmUp : Estimator::kPath,
          loaded.exposure};
}

CourseworkBuild buildWith(std::span<const Variant> mistakes, const fs::path& folder) {
  applyVariants(mistakes, folder);
  return buildCoursework(folder);
}

void runChecks(const Pair& pair, const CourseworkBuild& build, const PairOptions& options,
               PairFinding& finding) {
  checks::Selection selection;
  if (options.onlyPartsOfMistakes)
    std::erase_if(selection.parts, [&](int part) {
      return std::none_of(pair.mistakes.begin(), pair.mistakes.end(),
                          [&](const Variant& mistake) { return mistake.part == part; });
    });
  selection.images = selection.scenes = false;
  checks::RunOptions run;
  run.seed = options.seed;
  run.threads = options.threads;
  run.diagnose = false;
  const checks::CourseworkResults results = checks::runChecks(build, selection, run);
  finding.seconds = results.seconds;
  for (const checks::PartResult& part : results.parts) {
    bool atFault = !part.failure.empty();
    for (const checks::FunctionResult& f : part.functions) {
      if (f.status != checks::Status::kFail && f.status != checks::Status::kBroken) continue;
      finding.failed.push_back(std::string(f.function.name));
      atFault = true;
    }
    if (atFault) finding.partsAtFault.push_back(part.part.part);
  }
}

}  // namespace

std::string sceneWords(const Pair& pair) {
  if (pair.warmUp) return fmt::format("{} (warm-up)", pair.scene);
  if (!pair.maxBounces) return pair.scene;
  return fmt::format("{} ({} bounce{})", pair.scene, *pair.maxBounces,
                     *pair.maxBounces == 1 ? "" : "s");
}

bool hides(const PairFinding& finding) {
  return finding.same && finding.bias.high < kSeen &&
         std::all_of(finding.alone.begin(), finding.alone.end(),
                     [](const record::Estimate& alone) { return alone.low > kSeen; });
}

bool caught(const Pair& pair, const PairFinding& finding) {
  const auto holds = [](const auto& list, const auto& what) {
    return std::find(list.begin(), list.end(), what) != list.end();
  };
  std::vector<int> parts;
  for (const Variant& mistake : pair.mistakes) {
    if (!holds(finding.failed, mistake.function)) return false;
    parts.push_back(mistake.part);
  }
  return std::all_of(finding.partsAtFault.begin(), finding.partsAtFault.end(),
                     [&](int part) { return holds(parts, part); });
}

PairStudy::PairStudy(PairOptions options)
    : options_(std::move(options)), solutions_(buildCoursework(courseworkFolder("solutions"))) {
  if (options_.threads == 0) options_.threads = std::max(1u, std::thread::hardware_concurrency());
}

// Each picture has random numbers of its own, by its name: two have no noise in common, and a pair
// that is studied by itself gives the same numbers again.
marking::Measured PairStudy::picture(const CourseworkBuild& build,
                                     const marking::MarkingScene& scene, const std::string& name,
                                     const marking::Effort& effort) {
  if (!build.complete()) throw std::runtime_error(build.failure());
  WorkerProcess::Options options;
  options.program = build.worker;
  options.courseworkFolder = build.folder;
  WorkerProcess worker(std::move(options));
  std::uint64_t seed = mix(options_.seed + kGolden);
  for (const char c : name) seed = mix(seed + static_cast<unsigned char>(c));
  return marking::renderMeasured(worker, scene, seed, options_.threads, effort);
}

PairFinding PairStudy::of(const Pair& pair) {
  const marking::Effort fine{kRaysPerPixel * (pair.warmUp ? kTimesForWarmUp : 1), kReplicates};
  const marking::MarkingScene scene = sceneOf(pair);
  if (!solved_.contains(scene.name))
    solved_[scene.name] = picture(solutions_, scene, scene.name, fine);
  const Image& reference = solved_[scene.name].image;
  const CourseworkBuild together = buildWith(pair.mistakes, options_.scratch / pair.name);
  const Image hidden = picture(together, scene, pair.name, fine).image;

  PairFinding finding;
  finding.bias = marking::tileBias(hidden, reference);
  finding.meanErrors = marking::meanErrors(hidden, reference);
  finding.same =
      compareImages(hidden, reference, {kReplicates, kReplicates}, {.alpha = kSameAlpha}).same;
  for (const Variant& mistake : pair.mistakes) {
    const CourseworkBuild alone = buildWith({&mistake, 1}, options_.scratch / mistake.name);
    finding.alone.push_back(marking::tileBias(
        picture(alone, scene, fmt::format("{} {}", pair.name, mistake.name), {}).image, reference));
  }
  runChecks(pair, together, options_, finding);
  return finding;
}

}  // namespace pathmark::pairs
