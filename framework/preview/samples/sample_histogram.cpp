#include "preview/samples/sample_histogram.h"

#include "stats/cell_pools.h"
#include "stats/quantiles.h"

#include <algorithm>
#include <cmath>

namespace pathmark::preview {

namespace {

constexpr std::size_t kPiecesOfBar = 4;  // of the curve

// How many samples a tally's sum of weights is worth one of.
double meanWeight(const Tally& tally) {
  return tally.sum > 0.0 ? tally.sumOfSquares / tally.sum : 1.0;
}

}  // namespace

Histogram makeHistogram(const Marginal& marginal, std::span<const WeightedPlace> places,
                        std::size_t samples, std::size_t bars, bool weighted) {
  const double n = static_cast<double>(samples), width = marginal.high - marginal.low,
               step = width / static_cast<double>(bars);
  std::vector<Tally> tallies(bars);
  for (const WeightedPlace& p : places) {
    const double at = (marginal.coordinate(p.place) - marginal.low) / width;
    constexpr double kRounding = 1e-5;
    if (!(at >= -kRounding && at <= 1.0 + kRounding)) continue;
    const double bar = std::clamp(at, 0.0, 1.0) * static_cast<double>(bars);
    tallies[std::min(static_cast<std::size_t>(bar), bars - 1)].add(p.weight);
  }
  Histogram histogram{marginal.name, marginal.low, marginal.high, {}, {}};
  for (std::size_t k = 0; k < bars; ++k) {
    const double from = marginal.low + step * static_cast<double>(k);
    Bar bar;
    bar.share = tallies[k].sum / n;
    bar.expected = marginal.mass(from, from + step);
    const double variance =
        weighted ? bar.expected * meanWeight(tallies[k]) : bar.expected * (1.0 - bar.expected);
    bar.sigma = std::sqrt(std::max(variance, 0.0) / n);
    histogram.bars.push_back(bar);
    const double piece = step / static_cast<double>(kPiecesOfBar);
    for (std::size_t i = 0; i < kPiecesOfBar; ++i) {
      const double start = from + piece * static_cast<double>(i);
      histogram.curve.push_back(marginal.mass(start, start + piece) *
                                static_cast<double>(kPiecesOfBar));
    }
  }
  return histogram;
}

CellTest testCells(std::span<const double> masses, std::span<const Tally> cells,
                   std::size_t samples, std::size_t elsewhere, bool weighted) {
  // Of samples expected in a cell, so that its count is roughly normal.
  constexpr double kFewest = 8.0, kFewestWeighted = 16.0;
  const double n = static_cast<double>(samples);
  if (!weighted && elsewhere > 0) return {true, 0.0, masses.size()};
  const stats::CellPools pools(masses, (weighted ? kFewestWeighted : kFewest) / n);
  const std::size_t count = pools.probabilities.size();
  if (!pools.enough || count < 2) return {};

  std::vector<Tally> tallies(count);
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const std::size_t pool = pools.poolOf[cell];
    if (pool == stats::CellPools::kNone) {
      if (cells[cell].sum > 0.0) return {true, 0.0, count};
      continue;
    }
    tallies[pool].sum += cells[cell].sum;
    tallies[pool].sumOfSquares += cells[cell].sumOfSquares;
  }
  double statistic = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const double expected = n * pools.probabilities[k], error = tallies[k].sum - expected;
    statistic += error * error / (expected * (weighted ? meanWeight(tallies[k]) : 1.0));
  }
  // All counts add up to n; weights do not.
  const double degrees = static_cast<double>(count) - (weighted ? 0.0 : 1.0);
  if (!std::isfinite(statistic)) return {true, 0.0, count};
  return {true, stats::chiSquareTail(statistic, degrees), count};
}

}  // namespace pathmark::preview
