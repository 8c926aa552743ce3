// SphereOracle: a sphere seen from a point, in long double.
#pragma once

#include <pathmark/shapes.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pathmark::checks {

struct SphereOracle {
  using LongVector = glm::vec<3, long double, glm::defaultp>;

  LongVector centre, from;
  long double r, d, sinMax, oneMinusCosMax;

  SphereOracle(const Sphere& sphere, const Point& x)
      : centre(sphere.centre()),
        from(x),
        r(sphere.radius()),
        d(std::sqrt(glm::dot(from - centre, from - centre))),
        sinMax(r / d),
        oneMinusCosMax(sinMax * sinMax / (1.0L + std::sqrt((d - r) * (d + r)) / d)) {}

  bool outside() const { return d > r; }

  // From the point c + r n to the viewer.
  LongVector toViewer(const Vector& n) const { return from - centre - r * LongVector(n); }

  // The cosine, at c + r n, between the normal and the direction to the viewer.
  long double cosAtPoint(const Vector& n) const {
    const LongVector w = toViewer(n);
    return glm::dot(LongVector(n), w) / std::sqrt(glm::dot(w, w));
  }

  // Density of uniform sampling of the cone, per unit area, at c + r n.
  long double pdf(const Vector& n) const {
    const long double pi = std::numbers::pi_v<long double>;
    if (!outside()) return 1.0L / (4.0L * pi * r * r);
    const LongVector w = toViewer(n);
    const long double cosine = cosAtPoint(n);
    return cosine > 0.0L ? cosine / (2.0L * pi * glm::dot(w, w) * oneMinusCosMax) : 0.0L;
  }

  // (1 - cos(theta)) / (1 - cos(thetaMax)), theta at the viewer between the axis and c + r n:
  // uniform in [0,1] for directions uniform over the cone. By sin(theta) = sinMax sin(theta').
  double coneFraction(const Vector& n) const {
    const LongVector w = toViewer(n), across = glm::cross(LongVector(n), w);
    const long double sin2 = sinMax * sinMax * glm::dot(across, across) / glm::dot(w, w);
    return static_cast<double>(sin2 / (1.0L + std::sqrt(std::max(1.0L - sin2, 0.0L))) /
                               oneMinusCosMax);
  }

  // How much a rounding of the inputs changes the density at c + r n, relative to it.
  double condition(const Vector& n) const {
    const long double cosine = cosAtPoint(n);
    return static_cast<double>(std::max(1.0L / (cosine * cosine), d / (d - r)));
  }
};

}  // namespace pathmark::checks
