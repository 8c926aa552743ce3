#include "stats/replicate_test.h"

#include "stats/quantiles.h"
#include "stats/skewed_student.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace pathmark::stats {

namespace {

// Relative entropy of the two-valued distributions with these probabilities.
double entropy(double p, double q) {
  const auto term = [](double a, double b) { return a > 0.0 ? a * std::log(a / b) : 0.0; };
  return term(p, q) + term(1.0 - p, 1.0 - q);
}

// Standard errors within which an expected value is known for certain.
constexpr double kExactly = 8.0;

}  // namespace

ReplicateTest::ReplicateTest(double expected, double expectedStandardError,
                             const Guarantee& guarantee)
    : guarantee_(guarantee),
      expected_(expected),
      expectedVariance_(expectedStandardError * expectedStandardError) {}

void ReplicateTest::add(double replicate) {
  replicates_.add(replicate);
  finite_ = finite_ && std::isfinite(replicate);
  inRange_ = inRange_ && guarantee_.low <= replicate && replicate <= guarantee_.high;
}

// P(a mean at least as far out), two-sided, for any distribution on [low, high]: Hoeffding,
// "Probability Inequalities for Sums of Bounded Random Variables", JASA 58, 1963, theorem 1.
double ReplicateTest::boundedTail() const {
  const double range = guarantee_.high - guarantee_.low;
  if (!inRange_ || !std::isfinite(range)) return 1.0;
  const double reach = guarantee_.tolerance + kExactly * std::sqrt(expectedVariance_);
  const double mean = replicates_.mean();
  const double nearest = std::clamp(mean, expected_ - reach, expected_ + reach);
  if (nearest == mean) return 1.0;
  const double p = std::clamp((mean - guarantee_.low) / range, 0.0, 1.0);
  const double q = (nearest - guarantee_.low) / range;
  if (q <= 0.0 || q >= 1.0) return 0.0;
  return std::min(2.0 * std::exp(-static_cast<double>(replicates_.count()) * entropy(p, q)), 1.0);
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

  const bool bounded = std::isfinite(guarantee_.high - guarantee_.low);
  const double alpha = guarantee_.alpha / guarantee_.looks, share = bounded ? 0.5 : 1.0;
  const double t = studentCritical(share * alpha, degrees);
  const double root = std::sqrt(n);
  const auto critical = [&](double side) { return t * widening(t * skewness(side) / root); };
  const double side = result.error < 0.0 ? -1.0 : 1.0;
  result.skewness = skewness(side);
  result.critical = critical(side);
  const double excess = std::max(std::abs(result.error) - guarantee_.tolerance, 0.0);
  if (excess > 0.0) result.statistic = excess / result.standardError;  // infinite without variance

  if (bounded) result.pValue = boundedTail() / (1.0 - share);
  const double most = std::max(skewness(-1.0), skewness(1.0));
  if (t * most <= kMostSkewness * root) {
    const double straight = straightened(result.statistic, result.skewness / root);
    result.pValue = std::min(result.pValue, studentTail(straight, degrees) / share);
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
