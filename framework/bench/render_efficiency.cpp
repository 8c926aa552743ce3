#include "bench/alternate.h"
#include "bench/interrupted_run.h"
#include "bench/ray_rates.h"
#include "bench/render_bench.h"
#include "scene/blob_mesh.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace pathmark::bench {

namespace {

// Efficiencies at 256 rays per pixel, of whole processes with one thread, all on one machine: of
// the fastest peer that was measured (Mitsuba 3, variant llvm_ad_rgb, multijitter sampler), and of
// Cycles 3.4, by which the other is scaled to this machine.
struct StoredPeer {
  const char* scene;
  double mitsuba, cycles;
  Target target;
};
constexpr std::uint64_t kRaysOfStored = 256;
const StoredPeer kStored[] = {{"s1", 522.0, 120.0, {2.0, 10.0}},
                              {"s2", 934.0, 26.0, {2.0, 10.0}},
                              {"s3", 257.0, 156.0, {1.5, 5.0}}};

struct Samples {
  std::vector<double> relativeMse, mean, cpu;

  void add(const Image& image, const Image& reference, double cpuSeconds) {
    const Deviation deviation = deviationOf(image, reference);
    relativeMse.push_back(deviation.relativeMse);
    mean.push_back(deviation.mean);
    cpu.push_back(cpuSeconds);
  }
  Mean efficiency() const { return inverseOfProduct(meanOf(relativeMse), meanOf(cpu)); }
};

// The raw rate that a scene's renders are measured against.
struct RawRate {
  std::unique_ptr<RaySubject> subject;
  RayKind kind = RayKind::kChained;
  double RayRates::*way = &RayRates::flat;

  double measure(double seconds) const { return subject->rates(kind, seconds).*way; }
};

RawRate rawRateFor(const std::string& key) {
  if (key == "s1")
    return {std::make_unique<RaySubject>(cornellBox(), RaySubject::Ways::kFlatOnly),
            RayKind::kChained, &RayRates::flat};
  if (key == "s3")
    return {
        std::make_unique<RaySubject>(blobOnFloor(kBlobSubdivisions), RaySubject::Ways::kRawOnly),
        RayKind::kClosest, &RayRates::raw};
  return {};
}

struct SceneSamples {
  const BenchScene* scene = nullptr;
  RawRate raw;
  std::unique_ptr<RaySubject> seen;  // likewise, of rays that start where the render's do
  double raysPerPath = 0.0;
  Samples few, many, cycles;
  std::vector<double> cyclesRenderCpu, rawRate, seenRate;

  // Of each seed: what the additional rays cost, without the program's start.
  std::vector<double> pathRates(const RenderPlan& plan) const {
    std::vector<double> rates;
    for (std::size_t k = 0; k < many.cpu.size(); ++k)
      rates.push_back(scene->pixels() * static_cast<double>(plan.manyRays - plan.fewRays) /
                      (many.cpu[k] - few.cpu[k]));
    return rates;
  }

  // Of each seed: what is made per camera path, times paths, by a raw rate around these renders.
  double over(const std::vector<double>& rate, const RenderPlan& plan, double perPath) const {
    std::vector<double> ratios = pathRates(plan);
    for (std::size_t k = 0; k < ratios.size(); ++k) ratios[k] *= perPath / rate[k];
    return median(std::move(ratios));
  }
};

void measureOnce(RenderBench& bench, SceneSamples& samples, std::uint64_t seed) {
  const BenchScene& scene = *samples.scene;
  const auto render = [&](std::uint64_t rays, Samples& into) {
    bench.progress.show(fmt::format("{}, {} rays per pixel", scene.name, rays));
    const RunResult run =
        bench.runs.render({.scene = scene.name, .raysPerPixel = rays, .seed = seed});
    into.add(run.image, scene.reference, run.usage.cpuSeconds);
  };
  const RenderPlan& plan = bench.plan;
  const auto raw = [&] { return samples.raw.subject ? samples.raw.measure(plan.raySeconds) : 0.0; };
  const auto seen = [&] {
    return samples.seen ? samples.seen->rates(RayKind::kClosest, plan.raySeconds).raw : 0.0;
  };
  const double rawBefore = raw(), seenBefore = seen();
  render(plan.fewRays, samples.few);
  render(plan.manyRays, samples.many);
  samples.seenRate.push_back(0.5 * (seenBefore + seen()));
  samples.rawRate.push_back(0.5 * (rawBefore + raw()));
  bench.progress.advance(1.0);
  if (!bench.cycles) return;
  bench.progress.show(fmt::format("{}, {} rays per pixel, Cycles", scene.name, plan.manyRays));
  const CyclesResult run = bench.cycles->render(scene, plan.manyRays, seed);
  samples.cycles.add(run.image, scene.reference, run.usage.cpuSeconds);
  samples.cyclesRenderCpu.push_back(run.renderCpuSeconds);
  bench.progress.advance(1.0);
}

void addTable(RenderBench& bench, const std::vector<SceneSamples>& all) {
  Table table{"efficiency",
              "Efficiency, 1 / (relative MSE x CPU seconds of the whole process); one thread",
              {{"scene", "scene"},
               {"renderer", "renderer"},
               {"raysPerPixel", "rays/px", 0},
               {"relMse", "relMSE x 1e4", 3},
               {"relMseError", "+-", 3},
               {"cpuSeconds", "CPU s", 2},
               {"efficiency", "efficiency", 1},
               {"efficiencyError", "+-", 1},
               {"meanOff", "mean off, %", 3},
               {"meanOffError", "+-", 3}},
              {}};
  table.printHead();
  const auto row = [&](const BenchScene& scene, const std::string& renderer, std::uint64_t rays,
                       const Samples& samples) {
    const Mean mse = meanOf(samples.relativeMse), mean = meanOf(samples.mean),
               efficiency = samples.efficiency();
    table.add({scene.key + " " + scene.name, renderer, static_cast<double>(rays), 1e4 * mse.value,
               1e4 * mse.error, meanOf(samples.cpu).value, efficiency.value, efficiency.error,
               100.0 * mean.value, 100.0 * mean.error});
  };
  for (const SceneSamples& s : all) {
    row(*s.scene, "pathmark", bench.plan.fewRays, s.few);
    row(*s.scene, "pathmark", bench.plan.manyRays, s.many);
    if (bench.cycles) row(*s.scene, "Cycles", bench.plan.manyRays, s.cycles);
  }
  bench.report.tables.push_back(std::move(table));
}

void addMeanFigures(RenderBench& bench, const SceneSamples& s) {
  const auto add = [&](std::uint64_t rays, const Samples& samples) {
    const Mean mean = meanOf(samples.mean);
    bench.add({.key = fmt::format("{}MeanOff{}", s.scene->key, rays),
               .name = fmt::format("{}: mean against the reference's, {} rays", s.scene->key, rays),
               .value = 100.0 * std::abs(mean.value),
               .error = 100.0 * mean.error,
               .unit = "%",
               .target = Target{.must = 0.1, .moreIsBetter = false}});
  };
  add(bench.plan.fewRays, s.few);
  add(bench.plan.manyRays, s.many);
}

// Diffuse rays leave what the camera sees (Aila and Laine, "Understanding the Efficiency of Ray
// Traversal on GPUs", HPG 2009), as a render's do. Those from points by area leave mostly the
// floor's far parts and the blob's top for the sky, and cost less: they stand beside them without a
// target.
void addEmbreeFigures(RenderBench& bench, const SceneSamples& s) {
  const auto note = [](const RaySubject& subject, const std::vector<double>& rate) {
    return fmt::format(
        "raw {:.1f} M/s, independent diffuse bounces, of which {:.0f} % meet something",
        1e-6 * median(rate), 100.0 * subject.hitShare());
  };
  bench.add({.key = "s3PathsOverEmbree",
             .name = "s3: camera paths per second / raw Embree's rays, from what the camera sees",
             .value = s.over(s.seenRate, bench.plan, 1.0),
             .target = Target{0.45, 0.6},
             .note = note(*s.seen, s.seenRate)});
  bench.add({.key = "s3PathsOverEmbreeByArea",
             .name = "s3: camera paths per second / raw Embree's rays, from all surfaces by area",
             .value = s.over(s.rawRate, bench.plan, 1.0),
             .note = note(*s.raw.subject, s.rawRate)});
}

void addRateFigures(RenderBench& bench, const SceneSamples& s) {
  const std::string& key = s.scene->key;
  const double paths = median(s.pathRates(bench.plan));
  bench.add({.key = key + "Paths",
             .name = key + ": camera paths per second and core",
             .value = 1e-6 * paths,
             .unit = "M/s"});
  bench.add({.key = key + "Rays",
             .name = key + ": all rays per second and core",
             .value = 1e-6 * paths * s.raysPerPath,
             .unit = "M/s"});
  if (key == "s1")
    bench.add({.key = "s1RaysOverFlat",
               .name = "s1: all rays per second / raw chained rays, flat loop",
               .value = s.over(s.rawRate, bench.plan, s.raysPerPath),
               .target = Target{0.6, 0.8},
               .note = fmt::format("raw {:.1f} M/s; {:.2f} rays for each camera ray",
                                   1e-6 * median(s.rawRate), s.raysPerPath)});
  if (key == "s3") addEmbreeFigures(bench, s);
}

void addPeerFigures(RenderBench& bench, const SceneSamples& s) {
  const std::string& key = s.scene->key;
  const Mean ours = s.many.efficiency(), cycles = s.cycles.efficiency();
  const Mean overCycles = ratioOf(ours, cycles);
  bench.add(
      {.key = key + "OverCycles",
       .name = fmt::format("{}: efficiency / Cycles', {} rays", key, bench.plan.manyRays),
       .value = overCycles.value,
       .error = overCycles.error,
       .note = fmt::format("{}; {:.1f} of its {:.1f} CPU s are rendering", bench.cycles->version(),
                           meanOf(s.cyclesRenderCpu).value, meanOf(s.cycles.cpu).value)});
  for (const StoredPeer& stored : kStored) {
    if (key != stored.scene || bench.plan.manyRays != kRaysOfStored) continue;
    const double factor = cycles.value / stored.cycles;
    // Both come from what Cycles has reached here, and have its relative error.
    const double best = std::max(stored.mitsuba * factor, cycles.value);
    const Mean over = ratioOf(ours, {best, cycles.error * best / cycles.value});
    bench.add({.key = key + "OverBestPeer",
               .name = key + ": efficiency / the best peer's, 256 rays",
               .value = over.value,
               .error = over.error,
               .target = stored.target,
               .note = fmt::format("best peer {:.0f}, estimated: Mitsuba 3's stored {:.0f} x "
                                   "Cycles' efficiency here / stored, {:.2f}",
                                   best, stored.mitsuba, factor)});
  }
}

}  // namespace

void measureEfficiency(RenderBench& bench) {
  std::vector<SceneSamples> all;
  for (const BenchScene& scene : bench.scenes) {
    bench.progress.show("preparing rays for " + scene.name);
    SceneSamples samples;
    samples.scene = &scene;
    samples.raw = rawRateFor(scene.key);
    if (scene.key == "s3")
      samples.seen =
          std::make_unique<RaySubject>(asSeen(scene.scene.flat), RaySubject::Ways::kRawOnly);
    samples.raysPerPath = bench.runs.raysPerPath(scene.scene);
    all.push_back(std::move(samples));
  }
  for (int seed = 1; seed <= bench.plan.seeds; ++seed)
    for (SceneSamples& samples : all) measureOnce(bench, samples, static_cast<std::uint64_t>(seed));
  bench.progress.clear();
  addTable(bench, all);
  for (const SceneSamples& s : all) {
    addMeanFigures(bench, s);
    addRateFigures(bench, s);
    if (bench.cycles) addPeerFigures(bench, s);
  }
}

}  // namespace pathmark::bench
