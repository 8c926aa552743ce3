// Is the mean what it should be?
//
//   MeanTest       the settings: false-fail rate, tolerance, floor
//   testMean       the mean of independent samples against an expected value
//   testMeans      the means of two independent groups against each other
//   MeanEstimate   a mean with its variance, where the samples are not at hand
//   smallestError  the error that testMean finds almost surely
//
// Assumption: the samples are independent and equally distributed, and there are enough of them
// for the mean to be normal as far out as the tail alpha. Skewness fattens one tail of t and thins
// the other by the fraction z (2 z^2 + 1) / 6 |skewness| / sqrt(n) (first Edgeworth term; Hall,
// The Bootstrap and Edgeworth Expansion, 1992, section 2.6), z the normal quantile: for
// alpha = 1e-7 that is 51 |skewness| / sqrt(n), and much of it cancels in the two-sided rate. An
// estimator with rare large values needs more samples, or groups of them averaged first.
// Stratified or quasi-random points are not independent: give one number for each randomised
// replicate.
#pragma once

#include "stats/moments.h"
#include "stats/verdict.h"

#include <limits>

namespace pathmark::stats {

struct MeanTest {
  // Probability that a correct mean fails, two-sided.
  double alpha = 1e-7;

  // An error of at most this size is no error: rounding, or a bias that is accepted.
  double tolerance = 0.0;

  // The standard deviation of one sample is taken to be at least this, so that an estimator
  // (almost) without variance does not fail on its last digit.
  double deviationFloor = 0.0;
};

// Student's t. Needs at least two samples; fails for fewer and where the mean is not finite.
Verdict testMean(const RunningMoments& samples, double expected, const MeanTest& settings);

// Welch's t for groups of unequal variance, degrees of freedom by Satterthwaite.
Verdict testMeans(const RunningMoments& a, const RunningMoments& b, const MeanTest& settings);

// A mean, and the variance of this mean, estimated with so many degrees of freedom (infinitely many
// where the variance is known). Of a weighted sum of independent means, such as a pooled tile or a
// low-frequency mode of an image: PooledVariance, with each weight squared. The weights must
// not depend on the values. Skew samples call for fewer degrees than their number less one.
struct MeanEstimate {
  double mean = 0.0, variance = 0.0;
  double degrees = std::numeric_limits<double>::infinity();
};

// The same from estimates. settings.deviationFloor is the least standard error of either mean.
// Fails where a mean or a variance is not finite, a variance is negative or degrees are not
// positive.
Verdict testMeans(const MeanEstimate& a, const MeanEstimate& b, const MeanTest& settings);

// The error of the mean that testMean finds with probability `power`, given samples of this
// variance and number: critical value plus the power's quantile, in standard errors.
double smallestError(const RunningMoments& samples, const MeanTest& settings, double power = 0.999);

}  // namespace pathmark::stats
