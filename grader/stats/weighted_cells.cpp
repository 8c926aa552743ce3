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

}  // namespace

// One sample gives the vector w e_c, of covariance C = D - p p' with D = diag(E[w^2 in cell]). By
// Sherman & Morrison, C^-1 = D^-1 + D^-1 p p' D^-1 / (1 - p' D^-1 p), so that the statistic needs
// no matrix. With equal weights and probabilities that add up to one, C is singular (the cells
// always add up to n), the second term falls away and one degree of freedom with it.
//
// The squares of D^-1 are replaced by deviances, with counts in units of the cell's mean weight
// (Bohm & Zech, "Statistics of weighted Poisson events and its applications", NIM A 748, 2014).
// Both agree where errors are small; far out the tail of a count is that of its deviance (Cramer),
// while squares take the right tail of a count for normal.
Verdict WeightedCells::test(std::span<const double> probabilities, double alpha) const {
  assert(probabilities.size() == sum_.size());
  const double n = static_cast<double>(count_);
  Verdict impossible{.statistic = std::numeric_limits<double>::infinity()};

  const CellPools cells(probabilities, kMinExpected / n);
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

  double statistic = 0.0, shift = 0.0, rest = 1.0;
  for (std::size_t i = 0; i < pools.size(); ++i) {
    const Pool& pool = pools[i];
    const double p = cells.probabilities[i], error = pool.sum / n - p;
    // E[w^2 in cell] under the hypothesis: p times the mean weight, which is estimated.
    const double meanWeight = pool.sum > 0.0 ? pool.sumOfSquares / pool.sum : 1.0;
    const double variance = p * meanWeight;
    statistic += deviance(pool.sum / meanWeight, n * p / meanWeight);
    shift += p * error / variance;
    rest -= p * p / variance;
  }
  double degrees = static_cast<double>(pools.size());
  constexpr double kSingular = 1e-3;
  if (rest > kSingular)
    statistic += n * shift * shift / rest;
  else
    degrees -= 1.0;
  if (degrees < 1.0) return {};

  Verdict verdict;
  verdict.statistic = statistic;
  verdict.degrees = degrees;
  verdict.critical = chiSquareCritical(alpha, degrees);
  verdict.pValue = chiSquareTail(verdict.statistic, degrees);
  verdict.pass = verdict.statistic <= verdict.critical;
  return verdict;
}

}  // namespace pathmark::stats
