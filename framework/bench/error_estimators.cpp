#include "bench/error_estimators.h"

#include "host/display_path.h"
#include "host/interrupt.h"
#include "host/lab.h"
#include "host/worker_clock.h"
#include "scene/spelling.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace pathmark::bench {

namespace fs = std::filesystem;

namespace {

// All that is asked for in one go fits a pixel's pass; a lab's may be slow.
constexpr double kSecondsWithoutAnswer = 60.0;

WorkerProcess::Options workerOptions(const Coursework& coursework) {
  WorkerProcess::Options options;
  options.program = coursework.worker;
  options.courseworkFolder = coursework.folder;
  options.limits.secondsWithoutAnswer = kSecondsWithoutAnswer;
  options.onText = [](std::string_view text) { fmt::print(stderr, "{}", text); };
  return options;
}

AskedEstimator fromWord(const fs::path& coursework, const std::string& itself,
                        const std::string& word) {
  std::string_view rest = word;
  RenderWay way = takeWay(rest);
  const std::string name(rest);
  const std::size_t equals = name.find('=');
  if (equals != std::string::npos)
    return {name.substr(0, equals), findCoursework(name.substr(equals + 1)), true, std::move(way)};
  if (name == itself) return {word, coursework, true, std::move(way)};
  std::vector<std::string> names = labNames(coursework);
  if (std::find(names.begin(), names.end(), name) != names.end())
    return {word, coursework / "labs" / name, true, std::move(way)};
  names.insert(names.begin(), itself);
  const std::vector<std::string_view> views(names.begin(), names.end());
  throw UsageError(
      fmt::format("--estimators {}: it is one of {}, or NAME=FOLDER, and behind that "
                  "may stand +mis, +split4, +reuse16 and the like.{}",
                  word, fmt::join(names, ", "), didYouMean(name, views)));
}

void refuseName(const std::string& name) {
  const auto isPlain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.' || c == ' ' || c == '+';
  };
  if (name.empty() || !std::all_of(name.begin(), name.end(), isPlain))
    throw UsageError(fmt::format(
        "\"{}\" is no name for an estimator: it has letters, digits, spaces and _ - . + only.",
        name));
}

}  // namespace

std::vector<AskedEstimator> findEstimators(const std::string& with,
                                           const std::vector<std::string>& words) {
  const fs::path coursework = findCoursework(with);
  const std::string itself = courseworkName(with);
  std::vector<AskedEstimator> asked;
  if (words.empty()) {
    asked.push_back({itself, coursework, true, {}});
    for (const std::string& lab : labNames(coursework))
      asked.push_back({lab, coursework / "labs" / lab, false, {}});
  }
  for (const std::string& word : words) asked.push_back(fromWord(coursework, itself, word));
  for (std::size_t k = 0; k < asked.size(); ++k) {
    refuseName(asked[k].name);
    for (std::size_t earlier = 0; earlier < k; ++earlier)
      if (asked[earlier].name == asked[k].name)
        throw UsageError(fmt::format(
            "--estimators: {} stands there twice; NAME=FOLDER gives another name.", asked[k].name));
  }
  return asked;
}

RunningEstimator::RunningEstimator(const Coursework& coursework, const RenderWay& way,
                                   const LoadedScene& scene)
    : scene_(scene),
      way_(way),
      worker_(std::make_unique<WorkerProcess>(workerOptions(coursework))) {
  if (way.lightSampling == scene.flat.lightSampling) {
    worker_->loadScene(scene.flat);
    return;
  }
  FlatScene flat = scene.flat;
  flat.lightSampling = way.lightSampling;
  worker_->loadScene(flat);
}

std::optional<EstimatorRender> RunningEstimator::render(std::uint64_t raysPerPixel,
                                                        SamplerKind sampler, std::uint64_t seed) {
  RenderOptions options;
  options.raysPerPixel = raysPerPixel;
  options.threads = 1;
  options.seed = seed;
  options.sampler = sampler;
  options.estimator = way_.estimator;
  options.sharing = way_.sharing;
  const double before = cpuSecondsOf(worker_->pid());
  const RenderedImage made = renderImage(*worker_, settingsFor(scene_, options),
                                         [](const RenderStatus&) { return !interrupted(); });
  if (!made.complete) return std::nullopt;
  if (const std::string sentence = invalidSentence(made, way_.estimator); !sentence.empty())
    throw WorkerError(WorkerFault::kNonsense, sentence);
  return EstimatorRender{made.image, cpuSecondsOf(worker_->pid()) - before};
}

std::string whatIsUnwritten(const Coursework& coursework, const RenderWay& way) {
  WorkerProcess worker(workerOptions(coursework));
  const bool mis = way.estimator == Estimator::kMis;
  const auto isOfLab = [&](const FunctionContract& f) {
    return isLab(coursework.folder) && fs::exists(coursework.folder / partNumbered(f.part).file);
  };
  const auto isOfWay = [&](const FunctionContract& f) {
    return isBonus(f) && isUsed(f, way.estimator, way.lightSampling);
  };
  std::vector<FunctionContract> missing;
  for (const FunctionContract& f : makeStubReport(worker.stubs()).unwritten)
    if ((f.function == CourseworkFunction::kTracePath && !mis) ||
        f.function == CourseworkFunction::kRenderPixel || isOfLab(f) || isOfWay(f))
      missing.push_back(f);
  if (missing.empty()) return {};
  return fmt::format("{} {} not written yet", listOfNames(missing),
                     missing.size() == 1 ? "is" : "are");
}

}  // namespace pathmark::bench
