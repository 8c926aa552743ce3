// DirectionFrame: an orthonormal frame in double around an axis, for judging and for drawing.
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pathmark::preview {

inline constexpr double kDegree = std::numbers::pi / 180.0;

struct DirectionFrame {
  glm::dvec3 u, n, v;  // right-handed as u, v, n

  // Around z: u is x and v is y.
  explicit DirectionFrame(const glm::dvec3& axis) : n(glm::normalize(axis)) {
    const glm::dvec3 other = std::abs(n.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    u = glm::normalize(other - glm::dot(other, n) * n);
    v = glm::cross(n, u);
  }

  // u in the plane of the axis and `towards`, on the side of it where they are not parallel.
  DirectionFrame(const glm::dvec3& axis, const glm::dvec3& towards) : DirectionFrame(axis) {
    const glm::dvec3 across = towards - glm::dot(towards, n) * n;
    if (glm::dot(across, across) < 1e-12) return;
    u = glm::normalize(across);
    v = glm::cross(n, u);
  }

  glm::dvec3 direction(double cosine, double azimuth) const {
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
    return cosine * n + sine * (std::cos(azimuth) * u + std::sin(azimuth) * v);
  }

  // The azimuth of a direction in turns: in [0,1], 1 only by rounding.
  double turn(const glm::dvec3& d) const {
    const double angle = std::atan2(glm::dot(d, v), glm::dot(d, u)) / (2.0 * std::numbers::pi);
    return angle < 0.0 ? angle + 1.0 : angle;
  }
};

}  // namespace pathmark::preview
