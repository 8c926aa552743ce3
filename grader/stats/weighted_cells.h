// WeightedCells: chi-square for weighted samples in the cells of a partition.
#pragma once

#include "stats/verdict.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pathmark::stats {

// Tests that samples have the claimed density: sample x counts with the weight q(x)/pdf(x), q the
// expected density and pdf the claimed one, so that the mean weight in a cell is the integral of
// q over the cell whatever valid pdf was used. With the weight 1 this is Pearson's test.
//
// Assumptions: independent samples; bounded weights (with q the natural density and pdf a
// reasonable other one). Small cells are pooled until each expects at least kMinExpected samples,
// where the chi-square approximation holds as far out as alpha = 1e-7.
class WeightedCells {
 public:
  static constexpr double kMinExpected = 50.0;

  explicit WeightedCells(std::size_t cells) : sum_(cells, 0.0), sumOfSquares_(cells, 0.0) {}

  // A sample without a cell ("no sample", weight 0) is counted by addNone.
  void add(std::size_t cell, double weight = 1.0) {
    ++count_;
    sum_[cell] += weight;
    sumOfSquares_[cell] += weight * weight;
  }
  void addNone() { ++count_; }

  std::int64_t count() const { return count_; }

  // probabilities: the integral of q over each cell; they add up to at most 1. Mass in a cell of
  // probability 0 fails at once. alpha: probability that correct samples fail.
  Verdict test(std::span<const double> probabilities, double alpha) const;

 private:
  std::int64_t count_ = 0;
  std::vector<double> sum_, sumOfSquares_;
};

}  // namespace pathmark::stats
