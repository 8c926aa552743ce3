#include "checks/outline.h"

#include "checks/exact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::checks {

namespace {

glm::dvec3 acrossOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::cross(b - a, c - a);
}

// p = a + x v1 + y v2, in the plane of both.
glm::dvec2 affine(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& v1,
                  const glm::dvec3& v2) {
  const glm::dvec3 n = glm::cross(v1, v2), d = p - a;
  return glm::dvec2(glm::dot(glm::cross(d, v2), n), glm::dot(glm::cross(v1, d), n)) /
         glm::dot(n, n);
}

double toSegment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const double along = glm::dot(p - a, b - a) / glm::dot(b - a, b - a);
  return glm::length(p - a - std::clamp(along, 0.0, 1.0) * (b - a));
}

double toTriangle(const glm::dvec3& p, const std::array<glm::dvec3, 3>& t) {
  const glm::dvec2 b = affine(p, t[0], t[1] - t[0], t[2] - t[0]);
  if (b.x >= 0.0 && b.y >= 0.0 && b.x + b.y <= 1.0)
    return std::abs(glm::dot(glm::normalize(acrossOf(t[0], t[1], t[2])), p - t[0]));
  return std::min({toSegment(p, t[0], t[1]), toSegment(p, t[1], t[2]), toSegment(p, t[2], t[0])});
}

}  // namespace

Outline::Outline(std::vector<Point> vertices, std::vector<Indices> triangles)
    : vertices_(std::move(vertices)), triangles_(std::move(triangles)) {
  const auto count = static_cast<unsigned>(vertices_.size());
  if (triangles_.empty())
    for (unsigned i = 2; i < count; ++i) triangles_.push_back({0, i - 1, i});
  split_ = triangles_.size() == 1 ? 4 : triangles_.size() <= 4 ? 2 : 1;
  glm::dvec3 across(0.0);
  for (std::size_t k = 0; k < triangles_.size(); ++k) {
    const auto [a, b, c] = triangle(k);
    across += acrossOf(a, b, c);
    area_ += areaOf(k);
  }
  normal_ = Vector(glm::normalize(across));
  for (const Point& v : vertices_) {
    for (int axis = 0; axis < 3; ++axis)
      magnitude_ = std::max(magnitude_, std::abs(double{v[axis]}));
    for (const Point& w : vertices_)
      longest_ = std::max(longest_, glm::length(glm::dvec3(v) - glm::dvec3(w)));
  }
}

Words Outline::words() const {
  Words words;
  words.add(vertices_.size(), triangles_.size(), normal_, vertices_);
  for (const Indices& t : triangles_) words.add(t[0], t[1], t[2]);
  return words;
}

std::string Outline::text() const {
  std::string result;
  const std::size_t shown = std::min<std::size_t>(vertices_.size(), 6);
  for (std::size_t i = 0; i < shown; ++i)
    result += fmt::format("{}p{} = {}", i == 0 ? "" : ", ", i, checks::text(vertices_[i]));
  if (shown < vertices_.size()) result += fmt::format(" ... ({} vertices)", vertices_.size());
  return result;
}

std::array<glm::dvec3, 3> Outline::triangle(std::size_t k) const {
  const Indices& t = triangles_[k];
  return {glm::dvec3(vertices_[t[0]]), glm::dvec3(vertices_[t[1]]), glm::dvec3(vertices_[t[2]])};
}

double Outline::areaOf(std::size_t k) const {
  const auto [a, b, c] = triangle(k);
  return 0.5 * glm::length(acrossOf(a, b, c));
}

double Outline::distance(const Point& p) const {
  double nearest = toTriangle(glm::dvec3(p), triangle(0));
  for (std::size_t k = 1; k < triangles_.size(); ++k)
    nearest = std::min(nearest, toTriangle(glm::dvec3(p), triangle(k)));
  return nearest;
}

std::array<double, Outline::kMoments> Outline::moments(const glm::dvec3& p) const {
  const glm::dvec3 a(vertices_[0]);
  const auto [x, y] = [&] {
    const glm::dvec2 xy =
        affine(p, a, glm::dvec3(vertices_[1]) - a, glm::dvec3(vertices_.back()) - a);
    return std::pair{xy.x, xy.y};
  }();
  return {x, y, x * x, y * y, x * y};
}

// Each triangle in split * split congruent parts: columns of split, split - 1, ... squares of the
// barycentric coordinates, each square in two triangles but the last of its column.
std::size_t Outline::cellOf(const glm::dvec3& p) const {
  std::size_t best = 0;
  glm::dvec2 at(0.0);
  double deepest = -1e300;
  for (std::size_t k = 0; k < triangles_.size(); ++k) {
    const auto [a, b, c] = triangle(k);
    const glm::dvec2 xy = affine(p, a, b - a, c - a);
    const double inside = std::min({xy.x, xy.y, 1.0 - xy.x - xy.y});
    if (!(inside > deepest)) continue;
    deepest = inside;
    best = k;
    at = xy;
  }
  const auto split = static_cast<double>(split_);
  const double x = std::clamp(at.x, 0.0, 1.0) * split, y = std::clamp(at.y, 0.0, 1.0) * split;
  const std::size_t column = std::min(static_cast<std::size_t>(x), split_ - 1);
  const std::size_t row = std::min(static_cast<std::size_t>(y), split_ - 1 - column);
  const bool upper = (x - static_cast<double>(column)) + (y - static_cast<double>(row)) > 1.0 &&
                     column + row + 1 < split_;
  std::size_t cell = best * split_ * split_ + 2 * row + (upper ? 1 : 0);
  for (std::size_t c = 0; c < column; ++c) cell += 2 * (split_ - c) - 1;
  return cell;
}

std::vector<double> Outline::meansWith(const std::vector<double>& probabilities) const {
  std::vector<double> means(kMoments);
  for (std::size_t k = 0; k < triangles_.size(); ++k) {
    const auto [a, b, c] = triangle(k);
    // Over a triangle the mean of a quadratic is its mean at the middles of the edges.
    for (const glm::dvec3& middle : {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)}) {
      const auto m = moments(middle);
      for (std::size_t i = 0; i < kMoments; ++i) means[i] += probabilities[k] * m[i] / 3.0;
    }
  }
  const auto parts = static_cast<double>(split_ * split_);
  for (const double p : probabilities) means.insert(means.end(), split_ * split_, p / parts);
  return means;
}

std::vector<Mean> Outline::uniformMeans() const {
  std::vector<double> shares;
  for (std::size_t k = 0; k < triangles_.size(); ++k) shares.push_back(areaOf(k) / area_);
  const std::vector<double> expected = meansWith(shares);
  glm::dvec2 size(1.0);
  for (const Point& v : vertices_) {
    const auto m = moments(glm::dvec3(v));
    size = glm::max(size, glm::abs(glm::dvec2(m[0], m[1])));
  }
  const std::string along = "p1 - p0", last = fmt::format("p{} - p0", vertices_.size() - 1);
  const std::array<std::pair<std::string, double>, kMoments> names{{
      {fmt::format("mean of b1 (the point is p0 + b1 ({}) + b2 ({}))", along, last), size.x},
      {fmt::format("mean of b2 (the point is p0 + b1 ({}) + b2 ({}))", along, last), size.y},
      {fmt::format("mean of b1^2 (the point is p0 + b1 ({}) + b2 ({}))", along, last),
       size.x * size.x},
      {fmt::format("mean of b2^2 (the point is p0 + b1 ({}) + b2 ({}))", along, last),
       size.y * size.y},
      {fmt::format("mean of b1 b2 (the point is p0 + b1 ({}) + b2 ({}))", along, last),
       size.x * size.y},
  }};
  std::vector<Mean> means;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    Mean mean;
    mean.expected = expected[i];
    if (i < kMoments) {
      mean.what = names[i].first;
      mean.scale = names[i].second;
    } else {
      const std::size_t parts = split_ * split_, k = (i - kMoments) / parts;
      const auto& t = triangles_[k];
      mean.what = fmt::format("share of the points in {}the triangle p{} p{} p{}",
                              parts == 1 ? "" : fmt::format("one of {} equal parts of ", parts),
                              t[0], t[1], t[2]);
    }
    means.push_back(std::move(mean));
  }
  return means;
}

void Outline::add(const Point& p, double weight, std::span<double> sums) const {
  const auto m = moments(glm::dvec3(p));
  for (std::size_t i = 0; i < kMoments; ++i) sums[i] += weight * m[i];
  sums[kMoments + cellOf(glm::dvec3(p))] += weight;
}

}  // namespace pathmark::checks
