// worse: the larger of two errors, of which one that is no number is the worst of all.
#pragma once

#include <cmath>
#include <limits>

namespace pathmark::bench {

// std::max keeps its first argument where the second is NaN, as if nothing were wrong there.
inline double worse(double worst, double error) {
  if (std::isnan(worst) || std::isnan(error)) return std::numeric_limits<double>::infinity();
  return worst < error ? error : worst;
}

}  // namespace pathmark::bench
