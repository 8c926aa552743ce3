#include "bench/error_statistics.h"

#include "stats/quantiles.h"

#include <cmath>
#include <numeric>
#include <vector>

namespace pathmark::bench {

namespace {

constexpr double kOutside = 0.05;  // of what intervals are to hold

std::vector<std::size_t> allBut(std::size_t count, std::size_t left) {
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < count; ++k)
    if (k != left) kept.push_back(k);
  return kept;
}

}  // namespace

Interval jackknife(std::size_t replicates, const Statistic& statistic, double besides) {
  std::vector<std::size_t> all(replicates);
  std::iota(all.begin(), all.end(), std::size_t{0});
  Interval interval;
  interval.value = statistic(all);
  if (replicates < 2) return interval;
  const auto n = static_cast<double>(replicates);
  std::vector<double> values;
  double mean = 0.0, squares = 0.0;
  for (std::size_t k = 0; k < replicates; ++k) {
    values.push_back(statistic(allBut(replicates, k)));
    mean += values.back() / n;
  }
  for (const double v : values) squares += (v - mean) * (v - mean);
  const double error = std::sqrt((n - 1.0) / n * squares + besides * besides);
  const double half = stats::studentCritical(kOutside, n - 1.0) * error;
  interval.low = interval.value - half;
  interval.high = interval.value + half;
  interval.error = error;
  return interval;
}

Interval exponential(const Interval& logarithm) {
  const double value = std::exp(logarithm.value);
  return {value, std::exp(logarithm.low), std::exp(logarithm.high), value * logarithm.error};
}

double logOfMean(std::span<const double> values, std::span<const std::size_t> replicates) {
  double sum = 0.0;
  for (const std::size_t k : replicates) sum += values[k];
  const double mean = sum / static_cast<double>(replicates.size());
  return mean > 0.0 ? std::log(mean) : std::numeric_limits<double>::quiet_NaN();
}

double slope(std::span<const double> x, std::span<const double> y) {
  double n = 0.0, sumX = 0.0, sumY = 0.0;
  const auto counts = [&](std::size_t k) { return std::isfinite(x[k]) && std::isfinite(y[k]); };
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!counts(k)) continue;
    n += 1.0;
    sumX += x[k];
    sumY += y[k];
  }
  double across = 0.0, along = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!counts(k)) continue;
    const double dx = x[k] - sumX / n;
    across += dx * dx;
    along += dx * (y[k] - sumY / n);
  }
  return across > 0.0 ? along / across : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace pathmark::bench
