// Directions in double, for judges.
//
//   DoubleFrame   a frame to put directions in
//   atCosine      a direction as coursework gets it
#pragma once

#include <pathmark/types.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pathmark::checks {

// An orthonormal frame in double around `axis`, which need not be exactly unit length.
struct DoubleFrame {
  glm::dvec3 u, n, v;

  explicit DoubleFrame(const glm::dvec3& axis) : n(glm::normalize(axis)) {
    const glm::dvec3 other = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    u = glm::normalize(glm::cross(n, other));
    v = glm::cross(n, u);
  }

  glm::dvec3 direction(double cosine, double azimuth) const {
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
    return cosine * n + sine * (std::cos(azimuth) * u + std::sin(azimuth) * v);
  }

  double azimuth(const glm::dvec3& d) const {  // in [0, 2 pi)
    const double angle = std::atan2(glm::dot(d, v), glm::dot(d, u));
    return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
  }

  // x along u, y along n, z along v.
  glm::dvec3 local(const glm::dvec3& d) const {
    return {glm::dot(d, u), glm::dot(d, n), glm::dot(d, v)};
  }
};

// A unit vector at this cosine to the unit vector n (negative: below), at some azimuth.
inline Vector atCosine(const Vector& n, double cosine, double azimuth) {
  return Vector(glm::normalize(DoubleFrame(glm::dvec3(n)).direction(cosine, azimuth)));
}

}  // namespace pathmark::checks
