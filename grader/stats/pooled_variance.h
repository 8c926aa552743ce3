// PooledVariance: the variance of a sum of independent estimates, from an estimate of the variance
// of each.
#pragma once

#include <limits>

namespace pathmark::stats {

class PooledVariance {
 public:
  // `variance` is a variance estimated with this many degrees of freedom.
  void add(double variance, double degrees) {
    sum_ += variance;
    sumOfSquares_ += variance * variance / degrees;
  }

  void merge(const PooledVariance& other) {
    sum_ += other.sum_;
    sumOfSquares_ += other.sumOfSquares_;
  }

  double variance() const { return sum_; }

  // Degrees of freedom of variance() (Satterthwaite, "An Approximate Distribution of Estimates of
  // Variance Components", Biometrics Bulletin 2, 1946); infinite if there is no variance.
  double degrees() const {
    return sumOfSquares_ > 0.0 ? sum_ * sum_ / sumOfSquares_
                               : std::numeric_limits<double>::infinity();
  }

 private:
  double sum_ = 0.0, sumOfSquares_ = 0.0;
};

}  // namespace pathmark::stats
