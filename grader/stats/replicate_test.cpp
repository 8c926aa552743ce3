#include "stats/replicate_test.h"

#include "stats/quantiles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace pathmark::stats {

namespace {

// The critical value over that without skewness, for a = t G / sqrt(n): y = x / t solves
// y^2 - 2/3 a y^3 = 1, so that w = 1 / y is the largest root of w^3 - w + 2/3 a = 0.
double widening(double a) {
  constexpr double kRoot3 = std::numbers::sqrt3;
  return kRoot3 / (2.0 * std::cos(std::acos(std::max(-kRoot3 * a, -1.0)) / 3.0));
}

// The t without skewness that is as rare as this one; g = G / sqrt(n).
double straightened(double t, double g) {
  const double capped = g > 0.0 ? std::min(t, 1.0 / g) : t;
  return capped * std::sqrt(1.0 - 2.0 / 3.0 * capped * g);
}

// Relative entropy of the two-valued distributions with these probabilities.
double entropy(double p, double q) {
  const auto term = [](double a, double b) { return a > 0.0 ? a * std::log(a / b) : 0.0; };
  return term(p, q) + term(1.0 - p, 1.0 - q);
}

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

// Hoeffding, "Probability Inequalities for Sums of Bounded Random Variables", JASA 58, 1963,
// theorem 1: holds for every distribution on [low, high] with this mean.
bool ReplicateTest::impossible(double alpha) const {
  const double range = guarantee_.high - guarantee_.low;
  if (!inRange_ || !std::isfinite(range)) return false;
  const double mean = replicates_.mean(), uncertain = 8.0 * std::sqrt(expectedVariance_);
  const double reach = guarantee_.tolerance + uncertain;
  const double nearest = std::clamp(mean, expected_ - reach, expected_ + reach);
  if (nearest == mean) return false;
  const double p = std::clamp((mean - guarantee_.low) / range, 0.0, 1.0);
  const double q = (nearest - guarantee_.low) / range;
  if (q <= 0.0 || q >= 1.0) return true;
  return static_cast<double>(replicates_.count()) * entropy(p, q) > std::log(2.0 / alpha);
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
  const auto skewness = [&](double side) {  // of what makes an error of this sign likely
    return std::max(guarantee_.skewness, -side * replicates_.skewness() + std::sqrt(6.0 / n));
  };

  const double alpha = guarantee_.alpha / guarantee_.looks;
  const double t = studentCritical(0.5 * alpha, degrees);
  const auto critical = [&](double side) {
    return t * widening(t * skewness(side) / std::sqrt(n));
  };
  const double side = result.error < 0.0 ? -1.0 : 1.0;
  result.skewness = skewness(side);
  result.critical = critical(side);
  const double excess = std::max(std::abs(result.error) - guarantee_.tolerance, 0.0);
  if (excess > 0.0) {
    result.statistic = excess / result.standardError;  // infinite without variance
    result.pValue =
        std::isfinite(result.statistic)
            ? studentTail(straightened(result.statistic, result.skewness / std::sqrt(n)), degrees)
            : 0.0;
  }
  const double most = std::max(skewness(-1.0), skewness(1.0));
  const bool trusted = t * most <= kMostSkewness * std::sqrt(n);
  if (trusted) {
    const double q = studentCritical(2.0 * (1.0 - guarantee_.power) / guarantee_.looks, degrees);
    result.shown =
        guarantee_.tolerance + result.standardError * (std::max(critical(-1.0), critical(1.0)) +
                                                       q * widening(q * most / std::sqrt(n)));
  }
  if ((trusted && result.statistic > result.critical) || impossible(0.5 * alpha))
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
