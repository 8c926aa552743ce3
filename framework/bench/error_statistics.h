// What repeated renders tell, with 95 % intervals.
//
//   Interval     a value and where it lies
//   jackknife    of any statistic of independent replicates
//   logOfMean    the statistic behind errors, times and efficiencies
//   slope        of a straight line through points
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>

namespace pathmark::bench {

struct Interval {
  double value = std::numeric_limits<double>::quiet_NaN();
  double low = value, high = value;  // NaN if a single replicate tells nothing of it
  double error = value;              // standard error; NaN likewise
};

// A statistic of the replicates with these numbers.
using Statistic = std::function<double(std::span<const std::size_t> replicates)>;

// Tukey's jackknife (Miller, "The jackknife - a review", Biometrika 61, 1974): the standard error
// by leaving out each of n replicates in turn, and Student's t with n - 1 degrees of freedom. A
// statistic that is a mean gets the usual t interval. `besides` is the standard error of what all
// replicates have in common, such as their reference.
Interval jackknife(std::size_t replicates, const Statistic& statistic, double besides = 0.0);

// The interval of a positive number from that of its logarithm.
Interval exponential(const Interval& logarithm);

// NaN where the mean is not positive: an error that does not stand out of the reference's own.
double logOfMean(std::span<const double> values, std::span<const std::size_t> replicates);

// Least squares through (x, y), at least two points; points with NaN are left out.
double slope(std::span<const double> x, std::span<const double> y);

}  // namespace pathmark::bench
