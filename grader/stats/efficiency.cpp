#include "stats/efficiency.h"

#include "stats/moments.h"
#include "stats/quantiles.h"
#include "stats/skewed_student.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pathmark::stats {

namespace {

struct LogVariance {
  double value = 0.0;
  double below = 0.0, above = 0.0;  // half widths of its confidence interval
};

// By the jackknife, pseudo-values n log V - (n - 1) log V_without_x. They are skew, and their mean
// is too low where the largest values happen to be missing: the interval is widened upwards.
LogVariance logVariance(std::span<const double> estimates, double confidence, double floor) {
  const double n = static_cast<double>(estimates.size());
  RunningMoments all;
  for (const double x : estimates) all.add(x);
  const double sum = all.variance() * (n - 1.0), least = floor * floor;
  const double log = std::log(std::max(all.variance(), least));
  RunningMoments pseudo;
  for (const double x : estimates) {
    // The variance without x: its sum of squares about the mean of the others.
    const double without = (sum - (x - all.mean()) * (x - all.mean()) * n / (n - 1.0)) / (n - 2.0);
    pseudo.add(n * log - (n - 1.0) * std::log(std::max(without, least)));
  }
  const double reach = studentCritical(1.0 - confidence, n - 1.0), root = std::sqrt(n);
  const auto width = [&](double side) {
    const double skewness = std::max(side * pseudo.skewness(), 0.0) + std::sqrt(6.0 / n);
    return reach * widening(reach * skewness / root) * pseudo.standardError();
  };
  return {pseudo.mean(), width(-1.0), width(1.0)};
}

}  // namespace

EfficiencyRatio efficiencyRatio(const Replicates& a, const Replicates& b, double confidence,
                                double deviationFloor) {
  constexpr std::size_t kLeast = 3;  // for the variance without one
  if (a.estimates.size() < kLeast || b.estimates.size() < kLeast)
    return {.high = std::numeric_limits<double>::infinity()};
  const LogVariance first = logVariance(a.estimates, confidence, deviationFloor);
  const LogVariance second = logVariance(b.estimates, confidence, deviationFloor);
  const double log = second.value - first.value + std::log(b.cost / a.cost);
  return {std::exp(log), std::exp(log - std::hypot(first.above, second.below)),
          std::exp(log + std::hypot(first.below, second.above))};
}

Standing standing(const EfficiencyRatio& ratio, double threshold) {
  if (ratio.low >= threshold) return Standing::kAbove;
  return ratio.high < threshold ? Standing::kBelow : Standing::kOpen;
}

BandRange bandRange(const EfficiencyRatio& ratio, std::span<const double> thresholds) {
  BandRange range;
  for (const double threshold : thresholds) {
    range.lowest += ratio.low >= threshold ? 1 : 0;
    range.highest += ratio.high >= threshold ? 1 : 0;
  }
  return range;
}

}  // namespace pathmark::stats
