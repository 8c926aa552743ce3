#include "stats/replicate_test.h"

#include "stats/quantiles.h"
#include "stats/skewed_student.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace pathmark::stats {

ReplicateTest::ReplicateTest(double expected, double expectedStandardError,
                             const Guarantee& guarantee)
    : guarantee_(guarantee),
      expected_(expected),
      expectedVariance_(expectedStandardError * expectedStandardError) {}

void ReplicateTest::add(double replicate) {
  replicates_.add(replicate);
  finite_ = finite_ && std::isfinite(replicate);
}

Judgement ReplicateTest::judge(int look) const {
  assert(look >= 0 && look < guarantee_.looks);
  Judgement result{.mean = replicates_.mean(),
                   .error = replicates_.mean() - expected_,
                   .replicates = replicates_.count(),
                   .look = look};
  if (!finite_ || !std::isfinite(result.error)) {
    result.outcome = Outcome::kFail;
    result.statistic = std::numeric_limits<double>::infinity();
    result.pValue = 0.0;
    return result;
  }
  if (result.replicates < kMinReplicates) return result;

  const double n = static_cast<double>(result.replicates), degrees = n - 1.0;
  const double deviation = std::max(std::sqrt(replicates_.variance()), guarantee_.deviationFloor);
  result.standardError = std::sqrt(deviation * deviation / n + expectedVariance_);
  // Of noise below the floor only what is left of its third moment counts.
  const double noise = std::sqrt(replicates_.variance()) / deviation;
  const double measured = replicates_.skewness() * noise * noise * noise;
  const auto skewness = [&](double side) {  // of what makes an error of this sign likely
    return std::max(guarantee_.skewness, -side * measured + std::sqrt(6.0 / n));
  };

  const double alpha = guarantee_.alpha / guarantee_.looks;
  const double t = studentCritical(alpha, degrees);
  const double root = std::sqrt(n);
  const auto critical = [&](double side) { return t * widening(t * skewness(side) / root); };
  const double side = result.error < 0.0 ? -1.0 : 1.0;
  result.skewness = skewness(side);
  result.critical = critical(side);
  const double excess = std::max(std::abs(result.error) - guarantee_.tolerance, 0.0);
  if (excess > 0.0) result.statistic = excess / result.standardError;  // infinite without variance

  const double most = std::max(skewness(-1.0), skewness(1.0));
  if (t * most <= kMostSkewness * root) {
    const double straight = straightened(result.statistic, result.skewness / root);
    result.pValue = studentTail(straight, degrees);
    const double q = studentCritical(2.0 * (1.0 - guarantee_.power) / guarantee_.looks, degrees);
    const double reach = std::max(critical(-1.0), critical(1.0)) + q * widening(q * most / root);
    result.shown = guarantee_.tolerance + reach * result.standardError;
  }
  if (result.pValue < alpha)
    result.outcome = Outcome::kFail;
  else if (result.shown <= guarantee_.delta)
    result.outcome = Outcome::kPass;
  return result;
}

bool worse(const Judgement& a, const Judgement& b) {
  const auto rank = [](Outcome outcome) {
    return outcome == Outcome::kFail ? 2 : outcome == Outcome::kUndecided ? 1 : 0;
  };
  if (a.outcome != b.outcome) return rank(a.outcome) > rank(b.outcome);
  if (a.outcome == Outcome::kUndecided) return a.shown > b.shown;
  if (a.pValue != b.pValue) return a.pValue < b.pValue;
  return a.statistic > b.statistic;
}

}  // namespace pathmark::stats
