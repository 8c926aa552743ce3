#include "host/session.h"

#include "host/build_config.h"
#include "host/content_hash.h"
#include "host/coursework_builder.h"
#include "host/display_path.h"
#include "host/interrupt.h"
#include "host/progress_bar.h"
#include "host/shell_word.h"
#include "light_paths/error_text.h"
#include "light_paths/language.h"
#include "scene/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <thread>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

const fs::path kProjectFolder{build::kProjectFolder};
constexpr const char* kSceneFolders[] = {"scenes", "student/scenes"};

void addSceneNames(const fs::path& folder, std::vector<std::string>& names) {
  if (!fs::is_directory(folder)) return;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema")
      names.push_back(entry.path().stem().string());
}

}  // namespace

fs::path findCoursework(const std::string& with) {
  fs::path folder = courseworkFolder(with);
  if (fs::is_directory(folder)) return folder;
  const bool solved = fs::is_directory(kProjectFolder / "solutions");
  throw UsageError(
      fmt::format("--with {}: there is no folder {}; it is student{}, or the path of a "
                  "folder with the files part*.cpp.",
                  with, displayPath(folder), solved ? ", solutions" : ""));
}

std::string solvedCoursework() {
  return fs::is_directory(kProjectFolder / "solutions") ? "solutions" : "student";
}

std::string courseworkChoices(const std::string& byDefault) {
  constexpr const char* kFolder = "a folder of part*.cpp files";
  if (solvedCoursework() != "solutions") return fmt::format("student (default) or {}", kFolder);
  return byDefault == "solutions"
             ? fmt::format("solutions (default where there are any), student, or {}", kFolder)
             : fmt::format("student (default), solutions, or {}", kFolder);
}

std::string courseworkName(const std::string& with) {
  if (with == "student" || with == "solutions") return with;
  const fs::path normal = fs::absolute(with).lexically_normal();
  return (normal.has_filename() ? normal : normal.parent_path()).filename().string();
}

std::string withOption(const fs::path& folder) {
  std::error_code ignored;
  if (fs::equivalent(folder, kProjectFolder / "student", ignored)) return {};
  const fs::path whole = fs::absolute(folder).lexically_normal();
  const fs::path relative = whole.lexically_proximate(kProjectFolder);
  const bool outside = relative.is_absolute() || *relative.begin() == "..";
  return " --with " + shellWord((outside ? whole : relative).string());
}

Coursework prepareCoursework(const std::string& with) {
  const fs::path folder = findCoursework(with);
  const CourseworkBuild build = buildCoursework(folder);
  if (build.worker.empty()) throw CourseworkError(build.failure());
  for (const PartBuild& part : build.parts) std::fputs(part.messages.c_str(), stderr);
  return {courseworkName(with), folder, build.worker};
}

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const char* folder : kSceneFolders) addSceneNames(kProjectFolder / folder, names);
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> shippedSceneNames() {
  std::vector<std::string> names;
  addSceneNames(kProjectFolder / kSceneFolders[0], names);
  std::sort(names.begin(), names.end());
  return names;
}

fs::path shippedSceneFile(const std::string& name) {
  return kProjectFolder / kSceneFolders[0] / (name + ".json");
}

fs::path findScene(const std::string& scene) {
  if (fs::is_regular_file(scene) || scene.find('/') != std::string::npos ||
      fs::path(scene).extension() == ".json")
    return scene;
  for (const char* folder : kSceneFolders) {
    const fs::path file = kProjectFolder / folder / (scene + ".json");
    if (fs::exists(file)) return displayPath(file);
  }
  const std::vector<std::string> names = sceneNames();
  const std::vector<std::string_view> views(names.begin(), names.end());
  throw UsageError(
      fmt::format("There is no scene {}: it is one of {}, or the path of a .json file.{}", scene,
                  fmt::join(names, ", "), didYouMean(scene, views)));
}

SamplerKind findSampler(const std::string& name, std::string_view option) {
  if (const std::optional<SamplerKind> kind = samplerNamed(name)) return *kind;
  throw UsageError(
      fmt::format("{} {}: it is one of {}.", option, name, fmt::join(kSamplerNames, ", ")));
}

PathExpression findPaths(const std::string& text) {
  try {
    PathExpression expression(text);
    automatonFor(expression);  // may need too many states
    return expression;
  } catch (const ExpressionError& e) {
    throw UsageError(fmt::format("--paths: {}", textWithCaret(text, e)));
  }
}

std::string sceneHash(const LoadedScene& scene) {
  ContentHasher hasher;
  packScene(scene.flat, [&](std::span<const std::byte> bytes) { hasher.add(bytes); });
  return hasher.digits();
}

void letThrough(const PathExpression& paths, const FlatScene& scene, RenderSettings& settings) {
  settings.paths = paths.text();
  const LobesPresent lobes = lobesPresent(viewOf(scene));
  const PathAutomaton automaton = automatonFor(paths, lobes);
  // All light is let through by no filter at all, bit for bit.
  settings.automaton = isAllLight(automaton, lobes) ? PathAutomaton{} : automaton;
}

RenderSettings settingsFor(const LoadedScene& scene, const RenderOptions& options) {
  RenderSettings settings;
  settings.width = static_cast<int>(scene.flat.camera.width);
  settings.height = static_cast<int>(scene.flat.camera.height);
  settings.raysPerPixel = options.raysPerPixel;
  settings.replicates = options.replicates;
  settings.threads =
      options.threads != 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  settings.threads = std::min<std::uint32_t>(settings.threads, kMaxThreads);
  settings.seed = options.seed;
  settings.sampler = options.sampler;
  if (options.paths) letThrough(*options.paths, scene.flat, settings);
  settings.estimator = options.estimator;
  settings.sharing = options.sharing;
  return settings;
}

WorkerProcess::Options workerOptions(const Coursework& coursework, const RenderOptions& options,
                                     ProgressBar& bar) {
  WorkerProcess::Options worker;
  worker.program = coursework.worker;
  worker.courseworkFolder = coursework.folder;
  worker.limits.secondsWithoutAnswer = options.secondsWithoutAnswer;
  worker.onText = [&bar](std::string_view text) { bar.printAbove(text); };
  return worker;
}

std::string unwrittenNote(const LoadedScene& scene, Estimator estimator, const StubReport& stubs) {
  std::vector<FunctionContract> missing, bonus;
  for (const FunctionContract& f : stubs.unwritten)
    if (isUsed(f, estimator, scene.flat.lightSampling)) (isBonus(f) ? bonus : missing).push_back(f);
  std::string text;
  if (!missing.empty()) text += fmt::format("Not written yet: {}.\n", listOfNames(missing));
  if (!bonus.empty()) text += fmt::format("Not written yet, bonus: {}.\n", listOfNames(bonus));
  return text;
}

RenderOutcome renderScene(const Coursework& coursework, const LoadedScene& scene,
                          const RenderOptions& options, RenderState state,
                          const AfterStep& afterStep) {
  ProgressBar bar(fmt::format("{}, {}", scene.name, coursework.name));
  WorkerProcess process(workerOptions(coursework, options, bar));

  RenderOutcome outcome;
  outcome.stubs = makeStubReport(process.stubs());
  process.loadScene(scene.flat);
  ImageRender render(process, settingsFor(scene, options), std::move(state));
  const auto show = [&](const RenderStatus& status) {
    bar.show(status);
    return !interrupted();
  };
  while (!render.finished() && render.step(show))
    if (afterStep)
      if (const std::string line = afterStep(render.state()); !line.empty()) bar.printAbove(line);
  outcome.rendered = render.image();
  outcome.state = render.takeState();
  return outcome;
}

std::string invalidKinds(const InvalidPixels& invalid) {
  std::vector<std::string> kinds;
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count > 0) kinds.push_back(fmt::format("{} {}", count, what));
  };
  add(invalid.nan, "NaN");
  add(invalid.infinite, "infinite");
  add(invalid.negative, "negative");
  return fmt::format("{}", fmt::join(kinds, ", "));
}

std::string invalidSentence(const RenderedImage& image, Estimator estimator) {
  const InvalidPixels& invalid = image.invalid;
  if (invalid.count() == 0) return {};
  const auto width = static_cast<std::uint64_t>(image.image.width);
  const char* const who = estimator == Estimator::kWarmUp ? "get_ray_radiance"
                          : estimator == Estimator::kMis  ? "tracePathMIS"
                          : estimator == Estimator::kPath ? "renderPixel"
                                                          : "tracePath";
  return fmt::format(
      "{} returned {} values, first in pixel column {}, row {}: a radiance is finite and not "
      "negative. They are left out of the picture; pixels that have no other value are magenta.",
      who, invalidKinds(invalid), invalid.firstPixel % width, invalid.firstPixel / width);
}

std::string listOfNames(std::span<const FunctionContract> functions) {
  std::vector<std::string_view> names;
  for (const FunctionContract& f : functions) names.push_back(f.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace pathmark
