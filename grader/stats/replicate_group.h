// Several statistics of the same replicates, judged together.
//
//   RankedJudgement   of one statistic of a group
//   ReplicateMoments  a list of means, such as low-order moments of directions
//   ReplicateCells    the mean weight in each cell of a partition
//
// alpha of a group is shared equally among its statistics (Bonferroni): it holds however they
// depend on each other, so that quasi-random points may be used.
#pragma once

#include "stats/cell_pools.h"
#include "stats/replicate_test.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pathmark::stats {

struct RankedJudgement {
  std::size_t index = 0;  // of the statistic or the pool
  Judgement judgement;
};

class ReplicateMoments {
 public:
  struct Statistic {
    std::string name;
    double expected = 0.0, expectedStandardError = 0.0;
    Guarantee guarantee;  // its alpha is set by the group
  };

  // alpha: probability that any of the statistics fails although all are right.
  ReplicateMoments(std::vector<Statistic> statistics, double alpha);

  // One number for each statistic, all of the same replicate.
  void add(std::span<const double> replicate);

  // Worst first: the outcome of the group is that of the first.
  std::vector<RankedJudgement> judge(int look) const;

  const Statistic& statistic(std::size_t index) const { return statistics_[index]; }

 private:
  std::vector<Statistic> statistics_;
  std::vector<ReplicateTest> tests_;
};

// Tests that samples have the claimed density: sample x counts with the weight q(x)/pdf(x), q the
// expected density and pdf the claimed one, so that the mean weight in a cell is the integral of q
// over the cell whatever valid pdf was used. This is WeightedCells for points that depend on each
// other: instead of a chi-square over all cells, the worst cell decides. That finds a density that
// is wrong in one place with fewer points, and one that is a little wrong everywhere with more.
class ReplicateCells {
 public:
  // Points that a replicate is expected to have in a pool of cells: counts of independent points
  // then have a skewness of at most 8^-0.5 = 0.35.
  static constexpr double kMinExpected = 8.0;

  // probabilities: the integral of q over each cell. guarantee: of all cells together, its delta
  // an error of the integral over any one pool.
  ReplicateCells(std::span<const double> probabilities, std::int64_t pointsPerReplicate,
                 const Guarantee& guarantee);

  void add(std::size_t cell, double weight = 1.0);
  void addNone() { ++points_; }  // a point that is in no cell ("no sample", weight 0)

  // All points since the last call are one replicate.
  void endReplicate();

  // The worst pool. Mass in a cell of probability 0 fails at once.
  RankedJudgement judge(int look) const;

  const CellPools& pools() const { return pools_; }

 private:
  CellPools pools_;
  std::vector<ReplicateTest> tests_;
  std::vector<double> sums_;
  std::int64_t points_ = 0;
  bool massOutside_ = false;
};

}  // namespace pathmark::stats
