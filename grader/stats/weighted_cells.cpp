#include "stats/weighted_cells.h"

#include "stats/quantiles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace pathmark::stats {

namespace {

struct Pool {
  double probability = 0.0, sum = 0.0, sumOfSquares = 0.0;
};

}  // namespace

// One sample gives the vector w e_c, of covariance C = D - p p' with D = diag(E[w^2 in cell]). By
// Sherman & Morrison, C^-1 = D^-1 + D^-1 p p' D^-1 / (1 - p' D^-1 p), so that the statistic needs
// no matrix. With equal weights and probabilities that add up to one, C is singular (the cells
// always add up to n), the second term falls away and one degree of freedom with it.
Verdict WeightedCells::test(std::span<const double> probabilities, double alpha) const {
  assert(probabilities.size() == sum_.size());
  const double n = static_cast<double>(count_);
  Verdict impossible{.statistic = std::numeric_limits<double>::infinity()};

  std::vector<std::size_t> order(sum_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return probabilities[a] < probabilities[b]; });
  std::vector<Pool> pools;
  Pool open;
  for (const std::size_t cell : order) {
    if (!std::isfinite(sum_[cell])) return impossible;
    if (probabilities[cell] <= 0.0) {
      if (sum_[cell] != 0.0) return impossible;
      continue;
    }
    open.probability += probabilities[cell];
    open.sum += sum_[cell];
    open.sumOfSquares += sumOfSquares_[cell];
    if (n * open.probability >= kMinExpected) {
      pools.push_back(open);
      open = {};
    }
  }
  if (open.probability > 0.0) {
    if (pools.empty()) return {};  // too few samples to say anything
    pools.back().probability += open.probability;
    pools.back().sum += open.sum;
    pools.back().sumOfSquares += open.sumOfSquares;
  }

  double statistic = 0.0, shift = 0.0, rest = 1.0;
  for (const Pool& pool : pools) {
    const double p = pool.probability, error = pool.sum / n - p;
    // E[w^2 in cell] under the hypothesis: p times the mean weight, which is estimated.
    const double meanWeight = pool.sum > 0.0 ? pool.sumOfSquares / pool.sum : 1.0;
    const double variance = p * meanWeight;
    statistic += error * error / variance;
    shift += p * error / variance;
    rest -= p * p / variance;
  }
  double degrees = static_cast<double>(pools.size());
  constexpr double kSingular = 1e-3;
  if (rest > kSingular)
    statistic += shift * shift / rest;
  else
    degrees -= 1.0;
  if (degrees < 1.0) return {};

  Verdict verdict;
  verdict.statistic = n * statistic;
  verdict.degrees = degrees;
  verdict.critical = chiSquareCritical(alpha, degrees);
  verdict.pValue = chiSquareTail(verdict.statistic, degrees);
  verdict.pass = verdict.statistic <= verdict.critical;
  return verdict;
}

}  // namespace pathmark::stats
