#include "preview/samples/flat_polygon.h"

#include <algorithm>
#include <cmath>

namespace pathmark::preview {

namespace {

double cross2(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

double areaOf(const FlatTriangle& t) { return 0.5 * std::abs(cross2(t[1] - t[0], t[2] - t[0])); }

// With the corners in ascending order the width of the triangle rises linearly up to the middle one
// and falls linearly from there.
double areaBelow(const FlatTriangle& triangle, int axis, double value) {
  std::array<double, 3> x{triangle[0][axis], triangle[1][axis], triangle[2][axis]};
  std::sort(x.begin(), x.end());
  if (value <= x[0]) return 0.0;
  if (value >= x[2]) return areaOf(triangle);
  const double length = x[2] - x[0];
  const auto share = [&](double from, double side) { return from * from / (side * length); };
  return areaOf(triangle) *
         (value < x[1] ? share(value - x[0], x[1] - x[0]) : 1.0 - share(x[2] - value, x[2] - x[1]));
}

glm::dvec3 barycentrics(const FlatTriangle& t, const glm::dvec2& point) {
  const double whole = cross2(t[1] - t[0], t[2] - t[0]);
  const double b1 = cross2(point - t[0], t[2] - t[0]) / whole,
               b2 = cross2(t[1] - t[0], point - t[0]) / whole;
  return {1.0 - b1 - b2, b1, b2};
}

// Row r, by the second weight, has 2 (n - r) - 1 parts, upright ones and others in turn.
std::size_t partOf(const glm::dvec3& weights, std::size_t n) {
  const double side = static_cast<double>(n);
  const auto place = [&](double w) { return std::clamp(w * side, 0.0, side - 1e-9); };
  const auto row = static_cast<std::size_t>(place(weights.z));
  const std::size_t longest = n - row - 1;
  const auto column = std::min(static_cast<std::size_t>(place(weights.y)), longest);
  const double rest = (weights.y + weights.z) * side - static_cast<double>(row + column);
  const bool upright = rest < 1.0 || column == longest;
  const std::size_t before = row * (2 * n - row);  // the parts of the rows below
  return before + 2 * column + (upright ? 0 : 1);
}

}  // namespace pathmark::preview
