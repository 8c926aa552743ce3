#include "stats/cell_pools.h"

#include <algorithm>
#include <numeric>

namespace pathmark::stats {

CellPools::CellPools(std::span<const double> cells, double least) : poolOf(cells.size(), kNone) {
  std::vector<std::size_t> order(cells.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return cells[a] < cells[b]; });
  for (const std::size_t cell : order) {
    if (cells[cell] <= 0.0) continue;
    if (probabilities.empty() || probabilities.back() >= least) probabilities.push_back(0.0);
    poolOf[cell] = probabilities.size() - 1;
    probabilities.back() += cells[cell];
  }
  // What is left open at the end joins the pool before it.
  if (probabilities.size() > 1 && probabilities.back() < least) {
    const std::size_t last = probabilities.size() - 1;
    probabilities[last - 1] += probabilities[last];
    probabilities.pop_back();
    for (std::size_t& pool : poolOf)
      if (pool == last) pool = last - 1;
  }
  enough = !probabilities.empty() && probabilities.back() >= least;
}

}  // namespace pathmark::stats
