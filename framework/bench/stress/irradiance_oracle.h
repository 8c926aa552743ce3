// Irradiance of a unit radiance in closed form, in long double.
//
//   ofSphere    of a sphere that is wholly above the receiver's horizon
//   ofPolygon   of a polygon that is (Lambert, Photometria, 1760; see Arvo, "Analytic Methods for
//               Simulated Light Transport", 1995, section 2.4)
#pragma once

#include <pathmark/types.h>

#include <cmath>
#include <numbers>
#include <span>

namespace pathmark::bench::oracle {

using Real = long double;
using Vector3 = glm::vec<3, Real, glm::defaultp>;

inline Real lengthOf(const Vector3& v) { return std::sqrt(glm::dot(v, v)); }
inline Vector3 unit(const Vector3& v) { return v / lengthOf(v); }

// pi sin^2(thetaMax) cos(theta)
inline Real ofSphere(const Vector3& centre, Real radius, const Vector3& x, const Vector3& n) {
  const Vector3 toCentre = centre - x;
  const Real d = lengthOf(toCentre), sine = radius / d;
  return std::numbers::pi_v<Real> * sine * sine * glm::dot(unit(n), toCentre) / d;
}

// Half the sum over the edges of the angle under which each is seen, times the cosine between n and
// the normal of the plane through it and x. The angle by its tangent, which loses nothing where it
// is small.
inline Real ofPolygon(std::span<const Vector3> vertices, const Vector3& x, const Vector3& n) {
  Real sum = 0;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const Vector3 a = vertices[k] - x, b = vertices[(k + 1) % vertices.size()] - x;
    const Vector3 edge = vertices[(k + 1) % vertices.size()] - vertices[k];
    const Vector3 across = glm::cross(a, edge);  // a x b, from the shorter difference
    const Real sine = lengthOf(across);
    if (sine == 0) continue;
    sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(unit(n), across) / sine;
  }
  return std::abs(sum) / 2;
}

}  // namespace pathmark::bench::oracle
