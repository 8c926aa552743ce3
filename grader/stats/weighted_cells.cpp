#include "stats/weighted_cells.h"

#include "stats/cell_pools.h"
#include "stats/quantiles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace pathmark::stats {

namespace {

struct Pool {
  double sum = 0.0, sumOfSquares = 0.0;
};

// Deviance of a Poisson count, 2 (count log(count / expected) - (count - expected)).
double deviance(double count, double expected) {
  const double product = count > 0.0 ? count * std::log(count / expected) : 0.0;
  return std::max(2.0 * (product - (count - expected)), 0.0);
}

// Counts are whole numbers, so that the tail of their deviance falls in steps, which exceed that of
// chi-square by up to this factor. It is taken from alpha.
constexpr double kSteps = 1.5;

// Probabilities that differ from 1 by less than this add up to 1.
constexpr double kNegligible = 1e-3;

}  // namespace

// The sum over the cells of squared errors over variances n p E[w^2] / E[w], with the squares
// replaced by deviances of counts in units of the cell's mean weight (Bohm & Zech, "Statistics of
// weighted Poisson events and its applications", NIM A 748, 2014). Both agree where errors are
// small; far out the tail of a count is that of its deviance (Cramer), while squares take it for
// normal: at alpha = 1e-10 and 50 expected samples they fail 30 times as often as declared.
//
// Cells of one sum of samples are correlated, so that the statistic is smaller than chi-square
// with one degree of freedom for each cell. Where all weights are 1, what is in no cell is one
// more cell, and as all counts add up to n there is one degree less.
Verdict WeightedCells::test(std::span<const double> probabilities, double alpha) const {
  assert(probabilities.size() == sum_.size());
  const double n = static_cast<double>(count_);
  Verdict impossible{.statistic = std::numeric_limits<double>::infinity()};

  const CellPools cells(probabilities, (plain_ ? kMinExpected : kMinExpectedWeight) / n);
  std::vector<Pool> pools(cells.probabilities.size());
  for (std::size_t cell = 0; cell < sum_.size(); ++cell) {
    if (!std::isfinite(sum_[cell])) return impossible;
    if (cells.poolOf[cell] == CellPools::kNone) {
      if (sum_[cell] != 0.0) return impossible;
      continue;
    }
    Pool& pool = pools[cells.poolOf[cell]];
    pool.sum += sum_[cell];
    pool.sumOfSquares += sumOfSquares_[cell];
  }
  if (!cells.enough) return {};  // too few samples to say anything

  double statistic = 0.0, outside = 1.0, degrees = static_cast<double>(pools.size());
  for (std::size_t i = 0; i < pools.size(); ++i) {
    const Pool& pool = pools[i];
    const double meanWeight = pool.sum > 0.0 ? pool.sumOfSquares / pool.sum : 1.0;
    statistic += deviance(pool.sum / meanWeight, n * cells.probabilities[i] / meanWeight);
    outside -= cells.probabilities[i];
  }
  if (plain_ && n * outside >= kMinExpected)
    statistic += deviance(static_cast<double>(none_), n * outside);
  else if (plain_ && outside < kNegligible)
    degrees -= 1.0;
  if (degrees < 1.0) return {};

  Verdict verdict;
  verdict.statistic = statistic;
  verdict.degrees = degrees;
  verdict.critical = chiSquareCritical(alpha / kSteps, degrees);
  verdict.pValue = std::min(kSteps * chiSquareTail(verdict.statistic, degrees), 1.0);
  verdict.pass = verdict.statistic <= verdict.critical;
  return verdict;
}

}  // namespace pathmark::stats
