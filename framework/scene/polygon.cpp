#include "scene/polygon.h"

#include <algorithm>
#include <cmath>

namespace pathmark {
namespace {

// Whether the point, on the line through a and b, lies between them or on one of them.
bool isBetween(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& point) {
  return point.x >= std::min(a.x, b.x) && point.x <= std::max(a.x, b.x) &&
         point.y >= std::min(a.y, b.y) && point.y <= std::max(a.y, b.y);
}

bool segmentsMeet(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                  const glm::dvec2& d) {
  const double abc = orientation(a, b, c), abd = orientation(a, b, d);
  const double cda = orientation(c, d, a), cdb = orientation(c, d, b);
  const bool crosses = ((abc > 0.0 && abd < 0.0) || (abc < 0.0 && abd > 0.0)) &&
                       ((cda > 0.0 && cdb < 0.0) || (cda < 0.0 && cdb > 0.0));
  return crosses || (abc == 0.0 && isBetween(a, b, c)) || (abd == 0.0 && isBetween(a, b, d)) ||
         (cda == 0.0 && isBetween(c, d, a)) || (cdb == 0.0 && isBetween(c, d, b));
}

}  // namespace

glm::dvec3 newellVector(std::span<const glm::dvec3> vertices) {
  glm::dvec3 sum(0.0);
  // Relative to the first vertex, so that a small polygon far from the origin loses nothing.
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i) {
    sum += glm::cross(vertices[i] - vertices[0], vertices[i + 1] - vertices[0]);
  }
  return sum;
}

glm::dvec3 acrossVector(std::span<const glm::dvec3> vertices) {
  glm::dvec3 longest(0.0), across(0.0);
  for (const glm::dvec3& v : vertices)
    if (glm::length(v - vertices[0]) > glm::length(longest)) longest = v - vertices[0];
  for (const glm::dvec3& v : vertices) {
    const glm::dvec3 vector = glm::cross(longest, v - vertices[0]);
    if (glm::length(vector) > glm::length(across)) across = vector;
  }
  return across;
}

double diameter(std::span<const glm::dvec3> vertices) {
  glm::dvec3 low = vertices[0], high = vertices[0];
  for (const glm::dvec3& v : vertices) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  const glm::dvec3 extent = high - low;
  return std::max({extent.x, extent.y, extent.z});
}

double distanceFromPlane(std::span<const glm::dvec3> vertices, const glm::dvec3& normal) {
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& v : vertices) mean += v - vertices[0];
  mean = mean / static_cast<double>(vertices.size()) + vertices[0];
  double farthest = 0.0;
  for (const glm::dvec3& v : vertices) {
    farthest = std::max(farthest, std::abs(glm::dot(v - mean, normal)));
  }
  return farthest;
}

bool isParallelogram(std::span<const glm::dvec3> vertices, double tolerance) {
  if (vertices.size() != 4) return false;
  const glm::dvec3 gap = (vertices[0] - vertices[1]) + (vertices[2] - vertices[3]);
  return glm::length(gap) <= tolerance * diameter(vertices);
}

Outline project(std::span<const glm::dvec3> vertices, const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  const int dropped = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int first = (dropped + 1) % 3, second = (dropped + 2) % 3;
  if (normal[dropped] < 0.0) std::swap(first, second);
  Outline outline;
  outline.reserve(vertices.size());
  for (const glm::dvec3& v : vertices) outline.emplace_back(v[first], v[second]);
  return outline;
}

std::optional<std::array<std::size_t, 2>> findCrossing(const Outline& outline) {
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const glm::dvec2 &a = outline[i], &b = outline[next], &c = outline[(i + 2) % n];
    const bool foldsBack = orientation(a, b, c) == 0.0 && glm::dot(b - a, c - b) <= 0.0;
    if (foldsBack) return std::array{i, next};
    // The edge before the first one shares its vertex, as the next one does.
    const std::size_t last = i == 0 ? n - 1 : n;
    for (std::size_t j = i + 2; j < last; ++j) {
      if (segmentsMeet(a, b, outline[j], outline[(j + 1) % n])) return std::array{i, j};
    }
  }
  return std::nullopt;
}

}  // namespace pathmark
