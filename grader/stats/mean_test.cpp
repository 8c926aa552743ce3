#include "stats/mean_test.h"

#include "stats/pooled_variance.h"
#include "stats/quantiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pathmark::stats {

namespace {

double flooredVariance(const RunningMoments& samples, const MeanTest& settings) {
  return std::max(samples.variance(), settings.deviationFloor * settings.deviationFloor);
}

Verdict judge(double difference, double standardError, double degrees, const MeanTest& settings) {
  Verdict verdict;
  verdict.degrees = degrees;
  verdict.critical = studentCritical(settings.alpha, degrees);
  const double excess = std::max(std::abs(difference) - settings.tolerance, 0.0);
  if (excess == 0.0) {
    verdict.pValue = 1.0;
    verdict.pass = true;
  } else if (std::isfinite(excess)) {
    verdict.statistic = excess / standardError;  // infinite without variance
    verdict.pValue = std::isfinite(verdict.statistic) ? studentTail(verdict.statistic, degrees) : 0;
    verdict.pass = verdict.statistic <= verdict.critical;
  } else {
    verdict.statistic = std::numeric_limits<double>::infinity();
  }
  return verdict;
}

}  // namespace

Verdict testMean(const RunningMoments& samples, double expected, const MeanTest& settings) {
  if (samples.count() < 2) return {};
  const double n = static_cast<double>(samples.count());
  const double error = samples.mean() - expected;
  if (!std::isfinite(error)) return {.statistic = std::numeric_limits<double>::infinity()};
  return judge(error, std::sqrt(flooredVariance(samples, settings) / n), n - 1.0, settings);
}

Verdict testMeans(const RunningMoments& a, const RunningMoments& b, const MeanTest& settings) {
  if (a.count() < 2 || b.count() < 2) return {};
  const auto estimate = [&](const RunningMoments& samples) {
    const double n = static_cast<double>(samples.count());
    return MeanEstimate{samples.mean(), flooredVariance(samples, settings) / n, n - 1.0};
  };
  MeanTest floored = settings;
  floored.deviationFloor = 0.0;
  return testMeans(estimate(a), estimate(b), floored);
}

Verdict testMeans(const MeanEstimate& a, const MeanEstimate& b, const MeanTest& settings) {
  const double error = a.mean - b.mean, floor = settings.deviationFloor * settings.deviationFloor;
  PooledVariance sum;
  for (const MeanEstimate& one : {a, b}) {
    if (!(one.variance >= 0.0) || !std::isfinite(one.variance) || !(one.degrees > 0.0)) return {};
    sum.add(std::max(one.variance, floor), one.degrees);
  }
  if (!std::isfinite(error)) return {.statistic = std::numeric_limits<double>::infinity()};
  return judge(error, std::sqrt(sum.variance()), sum.degrees(), settings);
}

double smallestError(const RunningMoments& samples, const MeanTest& settings, double power) {
  if (samples.count() < 2) return std::numeric_limits<double>::infinity();
  const double n = static_cast<double>(samples.count()), degrees = n - 1.0;
  const double quantiles =
      studentCritical(settings.alpha, degrees) + studentCritical(2.0 * (1.0 - power), degrees);
  return settings.tolerance + quantiles * std::sqrt(flooredVariance(samples, settings) / n);
}

}  // namespace pathmark::stats
