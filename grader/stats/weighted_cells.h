// WeightedCells: chi-square for weighted samples in the cells of a partition.
#pragma once

#include "stats/verdict.h"

#include <cmath>
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
// or kMinExpectedWeight of weight where the mean weight of a cell has to be estimated too. The
// false-fail rate of these smallest pools, summed over all counts, is at most alpha for alpha from
// 1e-3 to 3e-13: with weights 1, and with the weights 1/2 and 3/2 in equal parts.
class WeightedCells {
 public:
  static constexpr double kMinExpected = 50.0;
  static constexpr double kMinExpectedWeight = 200.0;  // where weights differ from 1

  explicit WeightedCells(std::size_t cells) : sum_(cells, 0.0), sumOfSquares_(cells, 0.0) {}

  // A sample without a cell ("no sample", weight 0) is counted by addNone.
  void add(std::size_t cell, double weight = 1.0) {
    ++count_;
    plain_ = plain_ && std::abs(weight - 1.0) < kRounding;
    sum_[cell] += weight;
    sumOfSquares_[cell] += weight * weight;
  }
  void addNone() {
    ++count_;
    ++none_;
  }

  std::int64_t count() const { return count_; }

  // probabilities: the integral of q over each cell; they add up to at most 1. Mass in a cell of
  // probability 0 fails at once. alpha: probability that correct samples fail.
  Verdict test(std::span<const double> probabilities, double alpha) const;

 private:
  static constexpr double kRounding = 1e-4;  // of a weight 1 that is a quotient of floats

  std::int64_t count_ = 0, none_ = 0;
  bool plain_ = true;  // all weights are 1
  std::vector<double> sum_, sumOfSquares_;
};

}  // namespace pathmark::stats
