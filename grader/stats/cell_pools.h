// CellPools: cells of small probability put together until enough is expected in each pool.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace pathmark::stats {

struct CellPools {
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  std::vector<std::size_t> poolOf;    // for each cell; kNone for a cell of probability 0
  std::vector<double> probabilities;  // of each pool

  // least: probability of the smallest pool. Where all cells together have less, they are one pool.
  CellPools(std::span<const double> cells, double least);

  // Whether every pool has the least probability.
  bool enough = true;
};

}  // namespace pathmark::stats
