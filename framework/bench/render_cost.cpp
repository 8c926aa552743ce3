#include "bench/render_cost.h"

#include "bench/interrupted_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pathmark::bench {

namespace {

double pixelsOf(const std::string& scene) {
  const FlatCamera camera = loadScene(findScene(scene)).flat.camera;
  return static_cast<double>(camera.width) * camera.height;
}

double megabytes(const PeakMemory& peak) { return 1e-6 * static_cast<double>(peak.sum()); }

class Measurement {
 public:
  Measurement(const RenderRuns& runs, Progress& progress) : runs_(runs), progress_(progress) {}

  void add(const RenderRun& run, double startSeconds, CostPoint& point) {
    progress_.show(fmt::format("{} {}, {} rays per pixel", run.scene, run.size, run.raysPerPixel));
    point.cpuSeconds.push_back(runs_.render(run).usage.cpuSeconds - startSeconds);
    point.megabytes.push_back(megabytes(runs_.memory(run)));
    progress_.advance(1.0);
    stopIfInterrupted();
  }

  double start(const std::string& scene) {
    std::vector<double> seconds;
    for (int k = 0; k < 7; ++k) {
      progress_.show(fmt::format("{}, start", scene));
      seconds.push_back(
          runs_.render({.scene = scene, .raysPerPixel = 1, .size = "1x1"}).usage.cpuSeconds);
      stopIfInterrupted();
    }
    std::nth_element(seconds.begin(), seconds.begin() + 3, seconds.end());
    return seconds[3];
  }

 private:
  const RenderRuns& runs_;
  Progress& progress_;
};

}  // namespace

Cost measureCost(const CostPlan& plan, const RenderRuns& runs, Progress& progress) {
  Cost cost;
  for (const std::uint64_t rays : plan.raysPerPixel)
    cost.rays.points.push_back(
        {static_cast<double>(rays), pixelsOf(plan.scene) * static_cast<double>(rays), {}, {}});
  for (const int side : plan.sides) {
    const double pixels = static_cast<double>(side) * side;
    cost.pixels.points.push_back({pixels, pixels * static_cast<double>(plan.raysOfSides), {}, {}});
  }
  Measurement measurement(runs, progress);
  const double start = measurement.start(plan.scene);
  for (int repeat = 0; repeat < plan.repeats; ++repeat) {
    const auto seed = static_cast<std::uint64_t>(repeat);
    for (std::size_t k = 0; k < plan.raysPerPixel.size(); ++k)
      measurement.add({.scene = plan.scene, .raysPerPixel = plan.raysPerPixel[k], .seed = seed},
                      start, cost.rays.points[k]);
    for (std::size_t k = 0; k < plan.sides.size(); ++k)
      measurement.add({.scene = plan.scene,
                       .raysPerPixel = plan.raysOfSides,
                       .seed = seed,
                       .size = fmt::format("{0}x{0}", plan.sides[k])},
                      start, cost.pixels.points[k]);
  }
  return cost;
}

double microsecondsPerRay(const CostPoint& point) {
  const double seconds = std::accumulate(point.cpuSeconds.begin(), point.cpuSeconds.end(), 0.0);
  return 1e6 * seconds / static_cast<double>(point.cpuSeconds.size()) / point.cameraRays;
}

Interval costSlope(const CostSweep& sweep) {
  if (sweep.points.size() < 2) return {};
  return jackknife(sweep.points.front().cpuSeconds.size(), [&](auto chosen) {
    std::vector<double> amount, seconds;
    for (const CostPoint& p : sweep.points) {
      amount.push_back(std::log(p.amount));
      seconds.push_back(logOfMean(p.cpuSeconds, chosen));
    }
    return slope(amount, seconds);
  });
}

}  // namespace pathmark::bench
