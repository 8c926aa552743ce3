#include "checks/matt_room.h"

#include "checks/points.h"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pathmark::checks {

namespace {

using Vec = glm::dvec3;

constexpr Vec kSize(3.0, 2.2, 2.6);

// The share of the cosine-weighted hemisphere around n at x that a polygon fills, all of it above
// the horizon (Lambert's formula: half the sum of its edges' angles times the cosines of the edge
// planes' normals, over pi; Baum, Rushmeier & Winget, SIGGRAPH 1989, equation 9).
double formFactor(const Vec& x, const Vec& n, const std::array<Vec, 4>& polygon) {
  double sum = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec a = polygon[k] - x, b = polygon[(k + 1) % polygon.size()] - x;
    const Vec across = glm::cross(a, b);
    const double sine = glm::length(across);
    if (sine > 0.0) sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(n, across) / sine;
  }
  return std::abs(sum) * 0.5 * std::numbers::inv_pi;
}

struct Node {
  double at, weight;  // in [0,1], of a sum of 1
};

// Gauss and Legendre's.
std::vector<Node> nodes() {
  using Rule = boost::math::quadrature::gauss<double, 24>;
  std::vector<Node> all;
  for (std::size_t k = 0; k < Rule::abscissa().size(); ++k)
    for (const double side : {-1.0, 1.0})
      all.push_back({0.5 + 0.5 * side * Rule::abscissa()[k], 0.5 * Rule::weights()[k]});
  return all;
}

}  // namespace

MattRoom::MattRoom(std::uint64_t seed) {
  Random random(seed);
  const auto colour = [&](double low, double high) {
    const auto channel = [&] {
      return static_cast<double>(static_cast<float>(random.between(low, high)));
    };
    const double r = channel(), g = channel();
    return Vec(r, g, channel());
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      Vec e[3] = {{kSize.x, 0, 0}, {0, kSize.y, 0}, {0, 0, kSize.z}};
      const Vec a = e[(axis + 1) % 3], b = e[(axis + 2) % 3];
      const auto place = static_cast<std::size_t>(2 * axis + side);
      Wall& wall = walls_[place];
      wall.corner = side == 0 ? Vec(0.0) : e[axis];
      wall.v1 = side == 0 ? a : b;
      wall.v2 = side == 0 ? b : a;
      wall.n = glm::normalize(glm::cross(wall.v1, wall.v2));
      // One bright wall opposite a dim one along each axis.
      wall.emission = side == 0 ? colour(0.1, 0.4) : colour(0.8, 2.0);
      wall.kd = colour(0.3, 0.8);
    }
}

glm::dvec3 MattRoom::point(int wall, double u, double v) const {
  const Wall& w = walls_.at(static_cast<std::size_t>(wall));
  return w.corner + u * w.v1 + v * w.v2;
}

glm::dvec3 MattRoom::afterOneBounce(int wall, const Vec& x) const {
  const Wall& here = walls_[static_cast<std::size_t>(wall)];
  Vec arriving(0.0);
  for (const Wall& w : walls_)
    if (&w != &here)
      arriving += w.emission *
                  formFactor(x, here.n,
                             {w.corner, w.corner + w.v1, w.corner + w.v1 + w.v2, w.corner + w.v2});
  return here.emission + here.kd * arriving;
}

glm::dvec3 MattRoom::radiance(int wall, const Vec& x, int bounces) const {
  const Wall& here = walls_.at(static_cast<std::size_t>(wall));
  if (bounces == 0) return here.emission;
  if (bounces == 1) return afterOneBounce(wall, x);
  static const std::vector<Node> kNodes = nodes();
  Vec arriving(0.0);
  for (int other = 0; other < kWalls; ++other) {
    if (other == wall) continue;
    const Wall& w = walls_[static_cast<std::size_t>(other)];
    const double area = glm::length(glm::cross(w.v1, w.v2));
    for (const Node& s : kNodes)
      for (const Node& t : kNodes) {
        const Vec y = point(other, s.at, t.at), d = y - x;
        const double distance2 = glm::dot(d, d);
        const double cosines = glm::dot(d, here.n) * -glm::dot(d, w.n) / distance2;
        arriving += afterOneBounce(other, y) *
                    (s.weight * t.weight * area * cosines / (std::numbers::pi * distance2));
      }
  }
  return here.emission + here.kd * arriving;
}

SceneBuilder MattRoom::scene() const {
  SceneBuilder builder;
  for (const Wall& w : walls_)
    builder.parallelogram({.kd = Colour(w.kd), .emission = Colour(w.emission)}, Point(w.corner),
                          Vector(w.v1), Vector(w.v2));
  return builder;
}

}  // namespace pathmark::checks
