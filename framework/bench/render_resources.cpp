#include "bench/alternate.h"
#include "bench/interrupted_run.h"
#include "bench/render_bench.h"
#include "film/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace pathmark::bench {

namespace {

constexpr double kMegabyte = 1e6;

// The least that can be rendered.
constexpr std::string_view kOneTriangle = R"({
  "camera": {"eye": [0, 0, 3], "target": [0, 0, 0], "up": [0, 1, 0], "fieldOfView": 45},
  "size": [1, 1],
  "materials": {"white": {"type": "lambertian", "Kd": [0.5, 0.5, 0.5]}},
  "shapes": [{"type": "triangle", "material": "white", "emission": [1, 1, 1],
              "vertices": [[-1, -1, 0], [1, -1, 0], [0, 1, 0]]}]
}
)";

double megabytes(std::uint64_t bytes) { return static_cast<double>(bytes) / kMegabyte; }

// The kernel counts pages in batches, gives out more of them at times, and whoever looks every
// millisecond may miss the last one of a short run.
constexpr int kMemoryRuns = 7;

PeakMemory measureMemory(RenderBench& bench, const RenderRun& run, const std::string& what) {
  bench.progress.show("memory of " + what);
  const PeakMemory peak = bench.runs.memory(run);
  stopIfInterrupted();
  return peak;
}

PeakMemory medianMemory(RenderBench& bench, const RenderRun& run, const std::string& what) {
  std::vector<PeakMemory> peaks;
  peaks.reserve(kMemoryRuns);
  for (int k = 0; k < kMemoryRuns; ++k) peaks.push_back(measureMemory(bench, run, what));
  std::sort(peaks.begin(), peaks.end(),
            [](const PeakMemory& a, const PeakMemory& b) { return a.sum() < b.sum(); });
  return peaks[kMemoryRuns / 2];
}

// What one run needs beyond another, in megabytes. In turns: how much of the programs' files is
// mapped with the pages that are asked for depends on what the kernel has kept of them, and changes
// by megabytes.
double medianGrowth(RenderBench& bench, const RenderRun& few, const RenderRun& many) {
  std::vector<double> growth;
  for (int k = 0; k < kMemoryRuns; ++k) {
    const auto peak = [&](const RenderRun& run) {
      return megabytes(measureMemory(bench, run, run.scene).sum());
    };
    const double before = peak(few);
    growth.push_back(peak(many) - before);
  }
  return median(growth);
}

void addMemoryFigure(RenderBench& bench, const BenchScene& scene, const Target& target,
                     const PeakMemory& libraries) {
  const PeakMemory peak = medianMemory(bench, {.scene = scene.name, .raysPerPixel = 4}, scene.name);
  const auto over = [](std::uint64_t all, std::uint64_t base) {
    return megabytes(all) - megabytes(base);
  };
  bench.add({.key = scene.key + "Memory",
             .name = scene.key + ": peak memory beyond the libraries",
             .value = over(peak.sum(), libraries.sum()),
             .unit = "MB",
             .target = target,
             .note = fmt::format(
                 "resident at most (VmHWM) less that of one triangle in one pixel: host {:.1f} - "
                 "{:.1f}, worker {:.1f} - {:.1f} MB; memory that both see counts twice",
                 megabytes(peak.program), megabytes(libraries.program), megabytes(peak.children),
                 megabytes(libraries.children))});
}

}  // namespace

const BenchScene* RenderBench::find(std::string_view key) const {
  const auto found =
      std::find_if(scenes.begin(), scenes.end(), [&](const BenchScene& s) { return s.key == key; });
  return found == scenes.end() ? nullptr : &*found;
}

void measureThreads(RenderBench& bench) {
  const BenchScene& scene = bench.scenes.front();
  std::vector<double> one, two;
  bool same = true;
  for (int k = 0; k < bench.plan.seeds; ++k) {
    bench.progress.show(scene.name + ", one thread against two");
    RenderRun run{.scene = scene.name, .raysPerPixel = bench.plan.manyRays};
    const RunResult alone = bench.runs.render(run);
    run.threads = 2;
    const RunResult together = bench.runs.render(run);
    one.push_back(alone.renderSeconds);
    two.push_back(together.renderSeconds);
    same = same && alone.image.rgb == together.image.rgb;
    bench.progress.advance(1.0);
  }
  bench.add({.key = "twoThreads",
             .name = scene.key + ": two threads / one, speed of rendering",
             .value = median(one) / median(two),
             .target = Target{1.9, 1.97},
             .note = "on the wall's clock: other programs disturb it"});
  bench.add({.key = "sameBits",
             .name = scene.key + ": images with one and two threads have the same bits (1: yes)",
             .value = same ? 1.0 : 0.0,
             .target = Target{.must = 1.0}});
}

void measureStart(RenderBench& bench) {
  const auto measure = [&](std::string_view key, const Target& target) {
    const BenchScene* scene = bench.find(key);
    if (scene == nullptr) return;
    std::vector<double> seconds;
    for (int k = 0; k < bench.plan.repeats; ++k) {
      bench.progress.show(scene->name + ", start");
      const RenderRun run{.scene = scene->name, .raysPerPixel = 1, .size = "16x16"};
      seconds.push_back(bench.runs.render(run).usage.wallSeconds);
    }
    bench.progress.advance(1.0);
    bench.add({.key = scene->key + "Start",
               .name = scene->key + ": start to first tile, whole process",
               .value = 1e3 * median(seconds),
               .unit = "ms",
               .target = target});
  };
  measure("s1", {50.0, 20.0, false});
  measure("s3", {700.0, 400.0, false});
}

void measureMemoryUse(RenderBench& bench) {
  const std::filesystem::path file = bench.runs.folder() / "one_triangle.json";
  writeFileAtomically(file, kOneTriangle);
  const PeakMemory libraries =
      medianMemory(bench, {.scene = file.string(), .raysPerPixel = 1}, "the libraries");
  if (const BenchScene* s1 = bench.find("s1"))
    addMemoryFigure(bench, *s1, {30.0, 10.0, false}, libraries);
  if (const BenchScene* s3 = bench.find("s3"))
    addMemoryFigure(bench, *s3, {200.0, 130.0, false}, libraries);
  const BenchScene& scene = bench.scenes.front();
  const double growth = medianGrowth(bench, {.scene = scene.name, .raysPerPixel = 1},
                                     {.scene = scene.name, .raysPerPixel = bench.plan.manyRays});
  bench.progress.advance(1.0);
  bench.add({.key = "memoryGrowth",
             .name = fmt::format("{}: memory of {} rays per pixel beyond that of one", scene.key,
                                 bench.plan.manyRays),
             .value = growth,
             .unit = "MB",
             .target = Target{.must = 1.0, .moreIsBetter = false}});
}

}  // namespace pathmark::bench
