// How efficient is one estimator against another?
//
//   Replicates           independent estimates of the same value, and what one of them costs
//   EfficiencyRatio      of 1 / (variance x cost), with a confidence interval
//   efficiencyRatio      from the replicates of both
//   Standing, standing   above a threshold, below it, or not known
//   BandRange, bandRange the bands of a scale in which the ratio may lie
#pragma once

#include <span>

namespace pathmark::stats {

struct Replicates {
  std::span<const double> estimates;
  double cost = 1.0;  // of one replicate: rays, or seconds
};

// efficiency(a) / efficiency(b): above 1 where a is better.
struct EfficiencyRatio {
  double ratio = 0.0;
  double low = 0.0, high = 0.0;  // confidence interval
};

// Each variance's logarithm with its error by the jackknife (Miller, "Jackknifing Variances",
// Annals of Mathematical Statistics 39(2), 1968), which sees the kurtosis, unlike the F test.
// Student's t, widened upwards for skewness (skewed_student.h): the variance of replicates that
// happen to lack their largest values is estimated too low. Both errors are combined in quadrature
// side by side.
//
// Assumption: independent replicates, 64 or more, with a finite fourth moment. Measured for 64 and
// 256 replicates against 256, normal, uniform, exponential, lognormal and rarely bright, at
// confidence 0.99: the truth is above the interval, so that a looks worse than it is, in 0.05% to
// 0.45% of the cases (0.5% declared), and below it in at most 1% (64 lognormal replicates against
// normal ones), else 0.45%. Rarer bright values or heavier tails than these make a look better
// than it is more often.
//
// The standard deviation of a replicate is taken to be at least deviationFloor. With fewer than
// three replicates the interval is infinite.
EfficiencyRatio efficiencyRatio(const Replicates& a, const Replicates& b, double confidence = 0.99,
                                double deviationFloor = 0.0);

enum class Standing { kAbove, kBelow, kOpen };

// kAbove where the whole interval is at or above the threshold.
Standing standing(const EfficiencyRatio& ratio, double threshold);

// Band k of a scale lies from thresholds[k - 1] to thresholds[k]: 0 is below all of them.
struct BandRange {
  int lowest = 0, highest = 0;
};

// thresholds: ascending. The bands of both ends of the interval; the student gets the highest, or
// more replicates.
BandRange bandRange(const EfficiencyRatio& ratio, std::span<const double> thresholds);

}  // namespace pathmark::stats
