// TestPolygon: a polygon that owns its vertices and triangulation, and a partition of it.
#pragma once

#include "tests/support/quadrature.h"

#include <pathmark/shapes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace pathmark::testing {

class TestPolygon {
 public:
  using Indices = Polygon::TriangleIndices;

  TestPolygon(std::vector<Point> vertices, std::vector<Indices> triangles)
      : vertices_(std::move(vertices)),
        triangles_(std::move(triangles)),
        polygon_(vertices_, triangles_, Vector(normalOf(vertices_))) {}
  TestPolygon(const TestPolygon&) = delete;
  TestPolygon& operator=(const TestPolygon&) = delete;

  const Polygon* operator->() const { return &polygon_; }
  const Polygon& operator*() const { return polygon_; }

  double area() const {
    double sum = 0.0;
    for (int k = 0; k < polygon_.triangleCount(); ++k) sum += areaOf(k);
    return sum;
  }

  // Each triangle of the triangulation in kSplit * kSplit congruent parts.
  static constexpr std::size_t kSplit = 4;
  std::size_t cellCount() const { return triangles_.size() * kSplit * kSplit; }

  std::vector<double> cellProbabilities() const {
    std::vector<double> result;
    for (int k = 0; k < polygon_.triangleCount(); ++k)
      result.insert(result.end(), kSplit * kSplit, areaOf(k) / area() / (kSplit * kSplit));
    return result;
  }

  std::size_t cellOf(const Point& p) const {
    const auto [triangle, b] = locate(p);
    const double x = std::clamp(b.y, 0.0, 1.0) * kSplit, y = std::clamp(b.z, 0.0, 1.0) * kSplit;
    // Columns of kSplit, kSplit - 1, ... squares, each square in two triangles but the last.
    const std::size_t column = std::min(static_cast<std::size_t>(x), kSplit - 1);
    const std::size_t row = std::min(static_cast<std::size_t>(y), kSplit - 1 - column);
    const bool upper = (x - static_cast<double>(column)) + (y - static_cast<double>(row)) > 1.0 &&
                       column + row + 1 < kSplit;
    std::size_t cell = upper ? 1 : 0;
    for (std::size_t c = 0; c < column; ++c) cell += 2 * (kSplit - c) - 1;
    return triangle * kSplit * kSplit + cell + 2 * row;
  }

  // How far the point lies outside the polygon or off its plane, in barycentric units of the
  // triangle next to it and in units of the polygon's largest coordinate.
  double outside(const Point& p) const {
    const glm::dvec3 b = locate(p).second;
    return std::max(-std::min({b.x, b.y, b.z}), 0.0);
  }
  double offPlane(const Point& p) const {
    double magnitude = 0.0;
    for (const Point& v : vertices_)
      for (int axis = 0; axis < 3; ++axis)
        magnitude = std::max(magnitude, std::abs(double{v[axis]}));
    const glm::dvec3 n = glm::normalize(normalOf(vertices_));
    return std::abs(glm::dot(n, glm::dvec3(p) - glm::dvec3(vertices_[0]))) / magnitude;
  }

  glm::dvec3 centroid() const {
    glm::dvec3 sum(0.0);
    for (int k = 0; k < polygon_.triangleCount(); ++k) {
      const auto [a, b, c] = polygon_.triangle(k);
      sum += areaOf(k) / area() * (glm::dvec3(a) + glm::dvec3(b) + glm::dvec3(c)) / 3.0;
    }
    return sum;
  }

 private:
  // Newell's method: right for concave polygons.
  static glm::dvec3 normalOf(const std::vector<Point>& vertices) {
    glm::dvec3 sum(0.0);
    const glm::dvec3 origin(vertices[0]);
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
      sum += glm::cross(glm::dvec3(vertices[i]) - origin, glm::dvec3(vertices[i + 1]) - origin);
    return glm::normalize(sum);
  }

  double areaOf(int k) const {
    const auto [a, b, c] = polygon_.triangle(k);
    return 0.5 *
           glm::length(glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a)));
  }

  // The triangle that the point lies in (or least far out of) and its barycentric coordinates.
  std::pair<std::size_t, glm::dvec3> locate(const Point& p) const {
    std::pair<std::size_t, glm::dvec3> best{0, glm::dvec3(-1e300)};
    double bestInside = -1e300;
    for (int k = 0; k < polygon_.triangleCount(); ++k) {
      const auto corners = polygon_.triangle(k);
      const glm::dvec3 a(corners[0]), e1 = glm::dvec3(corners[1]) - a,
                                      e2 = glm::dvec3(corners[2]) - a, d = glm::dvec3(p) - a;
      const glm::dvec3 n = glm::cross(e1, e2);
      const double b1 = glm::dot(glm::cross(d, e2), n) / glm::dot(n, n),
                   b2 = glm::dot(glm::cross(e1, d), n) / glm::dot(n, n);
      const glm::dvec3 b(1.0 - b1 - b2, b1, b2);
      const double inside = std::min({b.x, b.y, b.z});
      if (inside > bestInside) {
        bestInside = inside;
        best = {static_cast<std::size_t>(k), b};
      }
    }
    return best;
  }

  std::vector<Point> vertices_;
  std::vector<Indices> triangles_;
  Polygon polygon_;
};

}  // namespace pathmark::testing
