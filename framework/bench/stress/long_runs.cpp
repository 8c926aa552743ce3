// A pixel of which a known share shows a lamp: however many rays are made, its error must go on
// falling as one over the square root of their number. A sum that stops growing, numbers that
// begin again or a film place that rounding moves would show.
#include "bench/stress/stress.h"
#include "bench/stress/worse.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

namespace pathmark::bench {

namespace {

constexpr int kHeight = 8;

// How far the lamp's edge reaches into each of its pixels. Of the eight columns of strata of a
// pass, three are lit and one is half lit.
constexpr double kShare = 3.5 / 8.0;

// One column of pixels, an upright edge through all of them; the lamp fills what is left of it.
LoadedScene edge() {
  const double x = (2.0 * kShare - 1.0) / kHeight;
  return sceneOf("edge", fmt::format(R"({{
    "camera": {{"eye": [0, 0, 1], "target": [0, 0, 0], "up": [0, 1, 0], "fieldOfView": 90}},
    "size": [1, {0}], "maxBounces": 0,
    "materials": {{"black": {{"type": "lambertian", "Kd": [0, 0, 0]}}}},
    "shapes": [{{"type": "rectangle", "material": "black", "emission": [0.3, 0.3, 0.3],
                "vertices": [[-4, -4, 0], [{1}, -4, 0], [{1}, 4, 0], [-4, 4, 0]]}}]}})",
                                     kHeight, x));
}

// Relative to the lamp's radiance.
double rmsError(const Image& image) {
  double sum = 0.0;
  for (int row = 0; row < kHeight; ++row) {
    const double share = static_cast<double>(image.pixel(0, row)[0]) / static_cast<double>(0.3f);
    sum += (share - kShare) * (share - kShare);
  }
  return std::sqrt(sum / kHeight);
}

// Of independent numbers: each pass has eight rays that are lit with probability 1/2.
double expectedError(double rays) { return std::sqrt(8.0 * 0.25 / 64.0 / rays); }

}  // namespace

void stressLongRuns(Stress& stress) {
  const int mostBits = stress.quick ? 20 : 25;
  stress.begin({.key = "longRuns",
                .title = "Long runs: rms error of 8 pixels, over that of independent rays",
                .columns = {{"rays", "rays per pixel"},
                            {"expected", "independent"},
                            {"pcg", "pcg", 2},
                            {"stratified", "stratified", 2},
                            {"sobol", "sobol", 2}},
                .rows = {}});
  const LoadedScene scene = edge();
  StressWorker worker(stress);
  worker.load(scene.flat);
  const std::array kinds{SamplerKind::kPcg, SamplerKind::kStratified, SamplerKind::kSobol};
  std::array<double, 3> last{};
  double worst = 0.0;
  std::vector<std::vector<Cell>> rows;
  std::vector<int> bits;
  for (int b = 10; b <= mostBits; b += b < 20 ? 5 : 4) bits.push_back(b);
  if (bits.back() != mostBits) bits.push_back(mostBits);
  double all = 0.0;
  for (const int b : bits) all += std::exp2(b);
  for (const int b : bits) {
    const double rays = std::exp2(b), expected = expectedError(rays);
    std::vector<Cell> cells{fmt::format("2^{}", b), fmt::format("{:.1e}", expected)};
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      stress.progress.show(fmt::format("2^{} rays, {}", b, nameOf(kinds[k])));
      RenderOptions options;
      options.raysPerPixel = std::uint64_t{1} << b;
      options.sampler = kinds[k];
      const double error = rmsError(worker.render(settingsFor(scene, options)).image);
      stress.progress.advance(60.0 / 3.0 * rays / all);
      last[k] = error / expected;
      worst = worse(worst, last[k]);
      cells.emplace_back(last[k]);
    }
    stress.row(std::move(cells));
  }
  // Eight times the squared ratio is chi-squared with 8 degrees of freedom for independent rays:
  // beyond 2.5 (50) with probability 4e-8. Better points have less.
  stress.addError("longRun", fmt::format("rms error over that expected, up to 2^{} rays", mostBits),
                  worst, 2.5, 2.5);
  stress.addError("longRunLast", fmt::format("the same of the last row, pcg: 2^{}", mostBits),
                  last[0], 2.5, 2.5);
}

}  // namespace pathmark::bench
