// A ray of its own for each stratum of a pixel, by Kuhn's algorithm for bipartite matchings.
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace pathmark::checks {

// A ray next to a border may count for the strata on either side.
class StrataMatching {
 public:
  // Points in pixels from the pixel's top left corner, in [0,1] to within the tolerance.
  StrataMatching(const std::vector<glm::dvec2>& points, int n, double tolerance)
      : pointsOf_(static_cast<std::size_t>(n) * static_cast<std::size_t>(n)),
        ownerOf_(points.size(), kNobody) {
    const auto cell = [n](double x) { return std::clamp(static_cast<int>(x * n), 0, n - 1); };
    for (std::size_t m = 0; m < points.size(); ++m) {
      const glm::dvec2 low = points[m] - tolerance, high = points[m] + tolerance;
      for (int l = cell(low.y); l <= cell(high.y); ++l)
        for (int k = cell(low.x); k <= cell(high.x); ++k)
          pointsOf_[static_cast<std::size_t>(l * n + k)].push_back(m);
    }
  }

  // Row n + column of a stratum for which no ray is left, if there is one.
  std::optional<std::size_t> emptyStratum() {
    for (std::size_t stratum = 0; stratum < pointsOf_.size(); ++stratum) {
      visited_.assign(ownerOf_.size(), false);
      if (!findPoint(stratum)) return stratum;
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kNobody = ~std::size_t{0};

  bool findPoint(std::size_t stratum) {
    for (const std::size_t m : pointsOf_[stratum]) {
      if (visited_[m]) continue;
      visited_[m] = true;
      if (ownerOf_[m] != kNobody && !findPoint(ownerOf_[m])) continue;
      ownerOf_[m] = stratum;
      return true;
    }
    return false;
  }

  std::vector<std::vector<std::size_t>> pointsOf_;  // of each stratum
  std::vector<std::size_t> ownerOf_;                // of each point
  std::vector<bool> visited_;
};

}  // namespace pathmark::checks
