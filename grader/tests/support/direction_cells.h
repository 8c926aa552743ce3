// DirectionCells: a partition of the directions around an axis, to test sampled directions in.
#pragma once

#include "stats/weighted_cells.h"
#include "tests/support/quadrature.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace pathmark::testing {

// Zones between given cosines to the axis, the first of them the lowest, each cut into sectors of
// equal azimuth. What lies below the lowest cosine has a cell of its own, the last.
class DirectionCells {
 public:
  DirectionCells(const glm::dvec3& axis, std::vector<double> cosines, std::size_t sectors)
      : frame_(axis), cosines_(std::move(cosines)), sectors_(sectors) {}

  std::size_t count() const { return (cosines_.size() - 1) * sectors_ + 1; }

  std::size_t cellOf(const glm::dvec3& direction) const {
    const double cosine = glm::dot(direction, frame_.n) / glm::length(direction);
    if (cosine < cosines_.front()) return count() - 1;
    const auto above = std::upper_bound(cosines_.begin(), cosines_.end() - 1, cosine);
    const auto zone = static_cast<std::size_t>(above - cosines_.begin()) - 1;
    const double sector =
        frame_.azimuth(direction) * static_cast<double>(sectors_) / (2.0 * std::numbers::pi);
    return zone * sectors_ + std::min(static_cast<std::size_t>(sector), sectors_ - 1);
  }

  // The integral of a density of total 1 over each cell; the last gets what is left.
  template <typename Density>
  std::vector<double> probabilities(Density&& density, int panels) const {
    std::vector<double> result;
    double left = 1.0;
    for (std::size_t zone = 0; zone + 1 < cosines_.size(); ++zone) {
      for (std::size_t sector = 0; sector < sectors_; ++sector) {
        const double width = 2.0 * std::numbers::pi / static_cast<double>(sectors_);
        const double from = width * static_cast<double>(sector);
        result.push_back(integrate(
            [&](double cosine) {
              return integrate(
                  [&](double azimuth) { return density(frame_.direction(cosine, azimuth)); }, from,
                  from + width, panels);
            },
            cosines_[zone], cosines_[zone + 1], panels));
        left -= result.back();
      }
    }
    // Quadrature leaves a little even where the cells cover everything.
    constexpr double kNothing = 1e-6;
    result.push_back(left > kNothing ? left : 0.0);
    return result;
  }

 private:
  DoubleFrame frame_;
  std::vector<double> cosines_;
  std::size_t sectors_;
};

}  // namespace pathmark::testing
