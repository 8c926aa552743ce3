#include "checks/irradiance.h"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pathmark::checks {

// Lambert 1760: half the sum over the edges of (angle the edge is seen under) times (cosine of
// the normal of the plane through edge and receiver to the receiver's normal).
double polygonIrradiance(const std::vector<glm::dvec3>& vertices, const glm::dvec3& x,
                         const glm::dvec3& n) {
  std::vector<glm::dvec3> above;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const glm::dvec3 a = vertices[i] - x, b = vertices[(i + 1) % vertices.size()] - x;
    const double ha = glm::dot(a, n), hb = glm::dot(b, n);
    if (ha >= 0.0) above.push_back(a);
    if ((ha > 0.0 && hb < 0.0) || (ha < 0.0 && hb > 0.0))
      above.push_back(a + ha / (ha - hb) * (b - a));
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < above.size(); ++i) {
    const glm::dvec3 a = glm::normalize(above[i]),
                     b = glm::normalize(above[(i + 1) % above.size()]);
    const glm::dvec3 across = glm::cross(a, b);
    const double sine = glm::length(across);
    if (sine > 0.0) sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(across / sine, n);
  }
  // Seen from the front, the vertices run clockwise around the direction to the light.
  return std::max(-0.5 * sum, 0.0);
}

double sphereIrradiance(double sinMax, double cosAxis) {
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  const double thetaMax = std::asin(sinMax), pi = std::numbers::pi;
  const double sinAxis = std::sqrt(1.0 - cosAxis * cosAxis);
  // Over the azimuth around the axis: the integral of max(0, a + b cos(phi)).
  const auto ring = [&](double theta) {
    const double a = std::cos(theta) * cosAxis, b = std::sin(theta) * sinAxis;
    double sum = 0.0;
    if (a >= b) {
      sum = 2.0 * pi * a;
    } else if (a > -b) {
      const double phi = std::acos(-a / b);
      sum = 2.0 * (a * phi + b * std::sin(phi));
    }
    return sum * std::sin(theta);
  };
  const auto panels = [&](double low, double high, int count) {
    double sum = 0.0;
    for (int k = 0; k < count; ++k)
      sum += Gauss::integrate(ring, low + (high - low) * k / count,
                              low + (high - low) * (k + 1) / count);
    return sum;
  };
  const double kink = std::clamp(std::abs(0.5 * pi - std::acos(cosAxis)), 0.0, thetaMax);
  return panels(0.0, kink, 8) + panels(kink, thetaMax, 64);
}

}  // namespace pathmark::checks
