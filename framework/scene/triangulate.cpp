#include "scene/triangulate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pathmark {
namespace {

// Of the areas, relative to the polygon's; rounding stays far below.
constexpr double kAreaTolerance = 1e-9;

bool isInside(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
              const glm::dvec2& point) {
  return orientation(a, b, point) >= 0.0 && orientation(b, c, point) >= 0.0 &&
         orientation(c, a, point) >= 0.0;
}

// What is left of the polygon: indices of its vertices, in order.
using Rest = std::vector<std::uint32_t>;

TriangleIndices cornerAt(const Rest& rest, std::size_t i) {
  const std::size_t n = rest.size();
  return {rest[(i + n - 1) % n], rest[i], rest[(i + 1) % n]};
}

// An ear is a convex corner whose triangle holds no other vertex, also not on its sides: so that a
// vertex in the middle of a straight side becomes a corner of a triangle, not a point of its edge.
bool isEar(const Outline& outline, const Rest& rest, std::size_t i) {
  const auto [a, b, c] = cornerAt(rest, i);
  if (orientation(outline[a], outline[b], outline[c]) <= 0.0) return false;
  return std::none_of(rest.begin(), rest.end(), [&, a = a, b = b, c = c](std::uint32_t v) {
    return v != a && v != b && v != c && isInside(outline[a], outline[b], outline[c], outline[v]);
  });
}

double doubleArea(const Outline& outline, const TriangleIndices& t) {
  return orientation(outline[t[0]], outline[t[1]], outline[t[2]]);
}

bool coversOnce(const Outline& outline, const std::vector<TriangleIndices>& triangles) {
  double polygon = 0.0, covered = 0.0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    polygon += orientation(outline[0], outline[i], outline[i + 1]);
  }
  for (const TriangleIndices& t : triangles) covered += doubleArea(outline, t);
  return polygon > 0.0 && std::abs(covered - polygon) <= kAreaTolerance * polygon;
}

}  // namespace

std::optional<std::vector<TriangleIndices>> triangulate(const Outline& outline) {
  if (outline.size() < 3) return std::nullopt;
  Rest rest(outline.size());
  std::iota(rest.begin(), rest.end(), 0u);
  std::vector<TriangleIndices> triangles;
  triangles.reserve(outline.size() - 2);

  std::size_t start = 0;
  while (rest.size() > 3) {
    std::size_t tried = 0;
    while (tried < rest.size() && !isEar(outline, rest, (start + tried) % rest.size())) ++tried;
    if (tried == rest.size()) return std::nullopt;
    const std::size_t ear = (start + tried) % rest.size();
    triangles.push_back(cornerAt(rest, ear));
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
    // Going on behind the ear's neighbour cuts a convex polygon into wide triangles, not into a
    // fan of slivers.
    start = (ear + 1) % rest.size();
  }
  triangles.push_back({rest[0], rest[1], rest[2]});
  if (doubleArea(outline, triangles.back()) <= 0.0 || !coversOnce(outline, triangles)) {
    return std::nullopt;
  }
  return triangles;
}

}  // namespace pathmark
