// What is asked of the roulette in 8.3.
#include "checks/channels.h"
#include "checks/hollow.h"
#include "checks/lopsided_furnace.h"
#include "checks/part8_checks.h"
#include "checks/path_estimates.h"
#include "checks/points.h"
#include "checks/standins/unfair_roulette.h"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <utility>

namespace pathmark::checks::path {

// With a roulette that is not fair the mean shows what it was asked. Where it comes is free, before
// the light that the ray finds or after it: each of these gives another mean, and any of them is
// right.
Finding unfairRoulette(CheckRun& run) {
  Random random(run.seed);
  const Hollow hollow(random);
  const Colour kd(0.9f, 0.8f, 0.0f), emission(1.0f, 0.5f, 2.0f);
  constexpr double kCosine = 0.8;
  constexpr std::array kBounces{1, 2};
  run.worker.loadScene(furnaceIn(hollow, kd, emission));
  std::vector<PathRay> rays;
  for (const int bounces : kBounces) rays.push_back({hollow.rayAt(kCosine, random), bounces});
  using Factor = std::function<double(int hit, int bounces)>;
  const auto meansBy = [&](LightBefore before, const Factor& factor) {
    std::vector<double> means;
    double sum = 0.0;
    for (const int bounces : kBounces)
      for (const int channel : {0, 1}) {
        const LopsidedFurnace furnace{double{emission[channel]}, double{kd[channel]}};
        means.push_back(unfairMisRadiance(furnace, kCosine, bounces, before,
                                          [&](int hit) { return factor(hit, bounces); }));
        sum += means.back() / furnace.emission;
      }
    means.push_back(sum);
    return means;
  };
  const Factor right = [](int hit, int) { return unfair::factor(hit); };
  const std::pair<const char*, Factor> mistakes[] = {
      {"RussianRoulette is not asked, or its answer is not used", [](int, int) { return 1.0; }},
      {"depth counts from 0: it is the number of scattering events so far, 1 at hit 1",
       [](int hit, int) { return unfair::factor(hit - 1); }},
      {"depth is one too large: it is the number of scattering events so far, 1 at hit 1",
       [](int hit, int) { return unfair::factor(hit + 1); }},
      {"the roulette is told maxBounces() as the depth: it is the number of scattering events so "
       "far, 1 at hit 1",
       [](int, int bounces) { return unfair::factor(bounces); }},
      {"the roulette is shown the throughput from before its update",
       [](int hit, int) { return hit == 1 ? 1.0 : unfair::factor(hit); }},
  };
  constexpr std::array kOrders{LightBefore::kNone, LightBefore::kLast, LightBefore::kAll};
  std::vector<Suspicion> suspicions;
  for (const auto& [words, factor] : mistakes)
    for (const LightBefore before : kOrders) suspicions.push_back({words, meansBy(before, factor)});
  PathEstimates estimates(run, rays, 512);
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    std::vector<double> all(6 * count);
    estimates.measure(first, count, all);
    for (std::size_t r = 0; r < count; ++r) {
      double* of = &values[5 * r];
      of[4] = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        of[k] = all[6 * r + 3 * (k / 2) + k % 2];
        of[4] += of[k] / double{emission[static_cast<int>(k % 2)]};
      }
    }
  };
  Finding first;
  for (const LightBefore before : kOrders) {
    const std::vector<double> expectedMeans = meansBy(before, right);
    std::vector<Mean> means;
    for (std::size_t k = 0; k < expectedMeans.size(); ++k)
      means.push_back({.what = k == 4 ? "radiance / emission, sum over all rays and channels"
                                      : fmt::format("{}, maxBounces() = {}",
                                                    inChannel("radiance", static_cast<int>(k % 2)),
                                                    kBounces[k / 2]),
                       .expected = expectedMeans[k],
                       .delta = k == 4 ? kRouletteDelta : 3.0 * kRouletteDelta,
                       .scale = expectedMeans[k]});
    Finding finding =
        judgeMeans(run, means, measure,
                   "inside a sphere that emits everywhere, with a roulette for testing: where the "
                   "throughput's blue is 0, as after every update here, its weight is not 1/q but "
                   "(1 + 1/(1 + depth)) / q",
                   suspicions);
    finding.calls = estimates.paths();
    if (before == kOrders[0]) first = finding;
    if (finding.passed()) return finding;
  }
  first.calls = estimates.paths();
  return first;
}

}  // namespace pathmark::checks::path
