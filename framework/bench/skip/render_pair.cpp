#include "bench/skip/render_pair.h"

#include "bench/alternate.h"
#include "bench/interrupted_run.h"
#include "bench/stress/stress.h"
#include "host/shared_memory.h"
#include "host/worker_clock.h"

#include <algorithm>
#include <cmath>

namespace pathmark::bench {

namespace {

class Side {
 public:
  Side(const LoadedScene& scene, const RenderSide& side, const PairPlan& plan)
      : worker_(optionsOf(side.coursework)),
        film_(static_cast<int>(scene.flat.camera.width),
              static_cast<int>(scene.flat.camera.height)) {
    worker_.loadScene(scene.flat, side.skips);
    RenderSettings settings;
    settings.raysPerPixel = plan.rays;
    job_.rays = plan.rays;
    job_.raysPerPass = settings.raysPerPass();
    job_.region = {0, 0, film_.width(), film_.height()};
    if (!side.tileRays.empty()) {
      job_.raysByTile = 1;
      std::copy(side.tileRays.begin(), side.tileRays.end(), film_.tileRays().begin());
    }
  }

  // Returns CPU seconds of the worker.
  double render() {
    std::ranges::fill(film_.pixels(), FilmPixel{});
    const double before = cpuSecondsOf(worker_.pid());
    worker_.render(job_, film_, [](const RenderProgress&) { return !interrupted(); });
    stopIfInterrupted();
    return cpuSecondsOf(worker_.pid()) - before;
  }

  Image image() const { return imageFromFilm(film_.width(), film_.height(), film_.pixels()); }

 private:
  static WorkerProcess::Options optionsOf(const Coursework& coursework) {
    WorkerProcess::Options options;
    options.program = coursework.worker;
    options.courseworkFolder = coursework.folder;
    options.limits.secondsWithoutAnswer = 120.0;
    options.onText = [](std::string_view) {};
    return options;
  }

  WorkerProcess worker_;
  SharedFilm film_;
  RenderJob job_;
};

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(
      std::llround(share * static_cast<double>(values.size() - 1)))];
}

}  // namespace

PairResult renderInTurn(const LoadedScene& scene, const RenderSide& first, const RenderSide& second,
                        const PairPlan& plan) {
  Side a(scene, first, plan), b(scene, second, plan);
  PairResult result;
  a.render();
  b.render();
  result.differing = differingValues(a.image(), b.image());
  result.difference = blockDifference(b.image(), a.image());
  std::vector<double> ratios;
  for (int k = 0; k < plan.rounds; ++k) {
    double timeA = 0.0, timeB = 0.0;
    // Who is first changes, so that a slow phase of the machine favours neither.
    if (k % 2 == 0) timeA = a.render();
    timeB = b.render();
    if (k % 2 != 0) timeA = a.render();
    ratios.push_back(timeB / timeA);
  }
  result.ratio = median(ratios);
  result.low = quantile(ratios, 0.25);
  result.high = quantile(ratios, 0.75);
  return result;
}

}  // namespace pathmark::bench
