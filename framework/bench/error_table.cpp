#include "bench/error_report.h"
#include "bench/error_words.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>

namespace pathmark::bench {

namespace {

constexpr const char* kRow =
    "{:<{}} {:<10} {:>7} {:>4}  {:>9}  {:>9}  {:>9} {:>6}  {:>10} {:>6}  {:>6}  {:>9}\n";

std::size_t widthOfNames(const SceneSummary& scene) {
  std::size_t width = 22;
  for (const CurveSummary& curve : scene.curves) width = std::max(width, curve.estimator.size());
  return width;
}

void printPoint(const CurveSummary& curve, const PointSummary& p, std::size_t width) {
  const std::string rays = p.raysPerPixel > 0 ? std::to_string(p.raysPerPixel) : "-";
  fmt::print(kRow, curve.estimator, width, curve.sampler, rays, p.replicates,
             threeDigits(p.cpuSeconds.value), threeDigits(p.mse.value),
             p.isMeasured() ? threeDigits(p.relativeMse.value) : "below",
             percentAround(p.relativeMse), threeDigits(p.efficiency.value),
             percentAround(p.efficiency), fmt::format("{:.1f} %", 100.0 * p.worstShare.value),
             fmt::format("{:+.2f} %", 100.0 * p.mean.value));
}

void printScene(const SceneSummary& scene) {
  fmt::print("\n{}\n", scene.scene);
  if (scene.reference.relativeMse > 0.0)
    fmt::print("  reference's own relative MSE, subtracted: {} +- {} (95 %)\n",
               threeDigits(scene.reference.relativeMse),
               threeDigits(1.96 * scene.reference.relativeMseError));
  else
    fmt::print("  reference without variances: its own error counts as that of the renders\n");
  const std::size_t width = widthOfNames(scene);
  fmt::print(kRow, "estimator", width, "sampler", "rays/px", "n", "CPU s", "MSE", "relMSE", "+-",
             "efficiency", "+-", "worst", "mean off");
  for (const CurveSummary& curve : scene.curves)
    for (const PointSummary& point : curve.points) printPoint(curve, point, width);
  const std::size_t widthWithSampler = width + 12;
  fmt::print("\n  {:<{}} {:>16}\n", "slope of log relMSE / log CPU s", widthWithSampler, "95 %");
  for (const CurveSummary& curve : scene.curves)
    fmt::print("  {:<{}} {:>16}\n", curve.name(), widthWithSampler, slopeWords(curve.slope));
}

}  // namespace

void printErrors(const ErrorFindings& findings, const std::string& machine) {
  for (const SceneSummary& scene : findings.scenes) printScene(scene);
  fmt::print(
      "\nrelMSE: mean of (x - reference)^2 / (reference^2 + 0.01), less the reference's own; "
      "below:\n"
      "does not stand out of that. efficiency: 1 / (relMSE x CPU s). +-: half of a 95 % interval\n"
      "over n replicates. worst: share of the squared error in the worst 0.1 % of the pixels.\n"
      "CPU s: of one thread, rendering only.\n{}\n",
      machine);
  for (const std::string& note : findings.notes) fmt::print(stderr, "{}\n", note);
  std::fflush(stdout);
}

}  // namespace pathmark::bench
