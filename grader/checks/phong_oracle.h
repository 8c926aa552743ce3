// The modified Phong model of Lafortune & Willems (1994), in double.
//
//   PhongMaterial   Kd, Ks and the exponent, and how the contract weighs the lobes
//   PhongLobes      both lobes for one wo: densities, and the angles that they depend on
//   lobeTolerance   how far roundings of the directions may carry cos^m(alpha)
#pragma once

#include "checks/calls.h"
#include "checks/exact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace pathmark::checks {

struct PhongMaterial {
  Colour kd, ks;
  float exponent = 0.0f;

  Words words() const { return Words().add(kd, ks, exponent); }

  // Probability of the diffuse lobe, in proportion to the means over the channels.
  double diffuseShare() const {
    const glm::dvec3 d(kd), s(ks);
    const double diffuse = d.x + d.y + d.z, specular = s.x + s.y + s.z;
    return diffuse / (diffuse + specular);
  }

  std::string text() const {
    return fmt::format("Kd = {}, Ks = {}, exponent = {:.6g}", checks::text(kd), checks::text(ks),
                       exponent);
  }
};

// Directions count as exactly unit: what their rounded lengths would change is rounding.
struct PhongLobes {
  glm::dvec3 wo, n, mirror;
  double m;

  PhongLobes(const Vector& wo_, const Vector& n_, float exponent)
      : wo(glm::normalize(glm::dvec3(wo_))),
        n(glm::normalize(glm::dvec3(n_))),
        mirror(glm::normalize(2.0 * glm::dot(wo, n) * n - wo)),
        m(exponent) {}

  double cosTheta(const glm::dvec3& wi) const { return glm::dot(wi, n); }
  double cosAlpha(const glm::dvec3& wi) const { return glm::dot(wi, mirror); }

  // cos^m(alpha); 0 where the lobe ends, for every exponent.
  double power(double cosAlpha) const { return cosAlpha > 0.0 ? std::pow(cosAlpha, m) : 0.0; }

  // Densities per solid angle of the two lobes.
  double diffuse(const glm::dvec3& wi) const {
    return std::max(cosTheta(wi), 0.0) / std::numbers::pi;
  }
  double specular(const glm::dvec3& wi) const {
    return (m + 1.0) / (2.0 * std::numbers::pi) * power(cosAlpha(wi));
  }
  double mixture(double diffuseShare, const glm::dvec3& wi) const {
    return diffuseShare * diffuse(wi) + (1.0 - diffuseShare) * specular(wi);
  }
};

// Relative error of cos^m(alpha) after 16 roundings of the cosine. The directions are unit vectors
// only up to rounding, so pow(dot(wi, R), m) may be off by this much, however exact the rest.
inline double lobeTolerance(double m, double cosAlpha) {
  constexpr double kMost = 3.0;
  return std::expm1(std::min(16.0 * 0x1p-24 * m / std::max(cosAlpha, 1e-4), kMost));
}

}  // namespace pathmark::checks
