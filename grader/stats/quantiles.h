// Quantiles and tails of the distributions that the tests need, and of samples.
//
//   studentCritical, chiSquareCritical   thresholds for a given false-fail rate alpha
//   studentTail, chiSquareTail           p-values
//   sampleQuantile                       of measured numbers
#pragma once

#include <span>

namespace pathmark::stats {

// The value that |t| exceeds with probability alpha, for Student's t with `degrees` degrees of
// freedom (two-sided). alpha in (0,1), degrees > 0, not only integers.
double studentCritical(double alpha, double degrees);

// P(|T| > |t|) for Student's T: two-sided.
double studentTail(double t, double degrees);

// The value that a chi-square variable exceeds with probability alpha.
double chiSquareCritical(double alpha, double degrees);

// P(X > x) for a chi-square variable.
double chiSquareTail(double x, double degrees);

// The q-quantile, q in [0,1], of numbers in ascending order, at least one: linear interpolation
// between order statistics (Hyndman & Fan 1996, type 7).
double sampleQuantile(std::span<const double> ascending, double q);

}  // namespace pathmark::stats
