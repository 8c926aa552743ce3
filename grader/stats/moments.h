// RunningMoments: count, mean, variance and third central moment of a stream of numbers.
#pragma once

#include <cmath>
#include <cstdint>

namespace pathmark::stats {

// One pass, without the cancellation of sum(x^2) - n mean^2: Welford 1962, with the third moment
// and the merging of two streams by Pebay, "Formulas for Robust, One-Pass Parallel Computation of
// Covariances and Arbitrary-Order Statistical Moments", Sandia report SAND2008-6212, 2008.
class RunningMoments {
 public:
  void add(double x) {
    const double before = static_cast<double>(count_);
    const double n = static_cast<double>(++count_);
    const double delta = x - mean_, step = delta / n, term = delta * step * before;
    mean_ += step;
    m3_ += term * step * (n - 2.0) - 3.0 * step * m2_;
    m2_ += term;
  }

  void merge(const RunningMoments& other) {
    if (other.count_ == 0) return;
    const double a = static_cast<double>(count_), b = static_cast<double>(other.count_);
    const double n = a + b, delta = other.mean_ - mean_;
    m3_ += other.m3_ + delta * delta * delta * a * b * (a - b) / (n * n) +
           3.0 * delta * (a * other.m2_ - b * m2_) / n;
    m2_ += other.m2_ + delta * delta * a * b / n;
    mean_ += delta * b / n;
    count_ += other.count_;
  }

  std::int64_t count() const { return count_; }
  double mean() const { return mean_; }

  // Unbiased variance of one number; 0 for fewer than two.
  double variance() const { return count_ < 2 ? 0.0 : m2_ / static_cast<double>(count_ - 1); }

  // Standard error of the mean.
  double standardError() const {
    return count_ == 0 ? 0.0 : std::sqrt(variance() / static_cast<double>(count_));
  }

  // Third central moment over the cube of the standard deviation; 0 where all numbers are equal.
  double skewness() const {
    if (!(m2_ > 0.0)) return 0.0;
    return std::sqrt(static_cast<double>(count_)) * m3_ / std::pow(m2_, 1.5);
  }

 private:
  std::int64_t count_ = 0;
  double mean_ = 0.0, m2_ = 0.0, m3_ = 0.0;  // m2_, m3_: sums of powers of x - mean
};

}  // namespace pathmark::stats
