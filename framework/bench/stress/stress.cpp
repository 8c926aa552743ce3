#include "bench/stress/stress.h"

#include "bench/interrupted_run.h"

#include <array>
#include <bit>
#include <cmath>
#include <thread>

namespace pathmark::bench {

namespace {

// A pass over a million coincident triangles takes its time.
constexpr double kSecondsWithoutAnswer = 120.0;

constexpr std::array kParts{
    StressPart{"similarity", "scenes in other units and at other places", 360.0, stressSimilarity},
    StressPart{"lights", "lights that are small, far, near, slender or around", 15.0, stressLights},
    StressPart{"materials", "exponents and reflectances at their ends", 15.0, stressMaterials},
    StressPart{"input", "random numbers at the ends of their range", 20.0, stressInput},
    StressPart{"long-runs", "many rays in a pixel", 60.0, stressLongRuns},
    StressPart{"threads", "numbers of threads and orders of tiles", 15.0, stressThreads},
    StressPart{"degenerate", "scenes at the edge of sense", 15.0, stressDegenerate},
};

WorkerProcess::Options workerOf(const Coursework& coursework) {
  WorkerProcess::Options options;
  options.program = coursework.worker;
  options.courseworkFolder = coursework.folder;
  options.limits.secondsWithoutAnswer = kSecondsWithoutAnswer;
  options.onText = [](std::string_view) {};
  options.goOn = [] { return !interrupted(); };
  return options;
}

template <class Work>
auto untilInterrupted(Work work) {
  try {
    return work();
  } catch (const WorkerStopped&) {
    throw Interrupted{};
  }
}

}  // namespace

std::span<const StressPart> stressParts() { return kParts; }

void Stress::begin(Table table) {
  progress.clear();
  table.printHead();
  report.tables.push_back(std::move(table));
}

void Stress::row(std::vector<Cell> cells) {
  progress.clear();
  report.tables.back().add(std::move(cells));
}

void Stress::addFaults(std::string key, std::string name, double faults, std::string note) {
  add({.key = std::move(key),
       .name = std::move(name),
       .value = faults,
       .target = Target{0.0, std::nullopt, false},
       .note = std::move(note)});
}

void Stress::addError(std::string key, std::string name, double error, double must, double aim,
                      std::string note) {
  add({.key = std::move(key),
       .name = std::move(name),
       .value = error,
       .target = Target{must, aim, false},
       .note = std::move(note)});
}

StressWorker::StressWorker(Stress& stress)
    : stress_(stress), process_(workerOf(stress.coursework)) {}

void StressWorker::load(const FlatScene& scene) {
  untilInterrupted([&] { process_.loadScene(scene); });
}

RenderedImage StressWorker::render(const RenderSettings& settings, RenderState state) {
  return untilInterrupted([&] {
    ImageRender render(process_, settings, std::move(state));
    while (!render.finished() && render.step([](const RenderStatus&) { return !interrupted(); })) {
    }
    stopIfInterrupted();
    RenderedImage image = render.image();
    stress_.invalid.add(image.invalid);
    stress_.passes += static_cast<double>(settings.pixels()) * image.raysPerPixel /
                      static_cast<double>(settings.raysPerPass());
    return image;
  });
}

std::vector<std::uint32_t> StressWorker::call(CourseworkFunction function,
                                              std::span<const std::uint32_t> object,
                                              std::span<const std::uint32_t> inputs) {
  return untilInterrupted([&] { return process_.call(function, object, inputs); });
}

std::vector<Estimate> StressWorker::estimate(const EstimateRequest& request,
                                             std::span<const std::uint32_t> inputs) {
  return untilInterrupted([&] { return process_.estimate(request, inputs); });
}

LoadedScene sceneOf(const std::string& name, const std::string& json) {
  return loadScene(SceneSource{name + ".json", json});
}

std::size_t differingValues(const Image& a, const Image& b) {
  if (a.rgb.size() != b.rgb.size()) return std::max(a.rgb.size(), b.rgb.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i)
    if (std::bit_cast<std::uint32_t>(a.rgb[i]) != std::bit_cast<std::uint32_t>(b.rgb[i]))
      ++different;
  return different;
}

}  // namespace pathmark::bench
