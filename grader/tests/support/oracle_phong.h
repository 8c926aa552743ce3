// PhongOracle: the modified Phong model in long double, for directions of exact unit length.
#pragma once

#include <pathmark/brdf.h>

#include <cmath>
#include <numbers>

namespace pathmark::testing {

using LongVector = glm::vec<3, long double, glm::defaultp>;

inline constexpr long double kPiL = std::numbers::pi_v<long double>;

struct PhongOracle {
  LongVector wo, wi, n;
  long double m;

  PhongOracle(const Vector& wo_, const Vector& wi_, const Vector& n_, float exponent)
      : wo(normalise(wo_)), wi(normalise(wi_)), n(normalise(n_)), m(exponent) {}

  static LongVector normalise(const Vector& v) {
    const LongVector exact(v);
    return exact / std::sqrt(glm::dot(exact, exact));
  }

  LongVector mirror() const { return 2.0L * glm::dot(wo, n) * n - wo; }
  long double cosAlpha() const { return glm::dot(wi, mirror()); }

  // cos^m(alpha); 0 where the lobe ends, for every exponent.
  long double lobe() const {
    const long double c = cosAlpha();
    return c > 0.0L ? std::pow(c, m) : 0.0L;
  }

  bool bothAbove() const { return glm::dot(wo, n) > 0.0L && glm::dot(wi, n) > 0.0L; }

  long double brdf(long double kd, long double ks) const {
    return bothAbove() ? kd / kPiL + ks * (m + 2.0L) / (2.0L * kPiL) * lobe() : 0.0L;
  }

  // diffuse: probability of the diffuse lobe.
  long double pdf(long double diffuse) const {
    return diffuse * std::max(glm::dot(wi, n), 0.0L) / kPiL +
           (1.0L - diffuse) * (m + 1.0L) / (2.0L * kPiL) * lobe();
  }

  // How much a rounding of the directions changes the lobe, relative to it: m tan(alpha).
  double condition() const {
    const long double c = std::max(cosAlpha(), 1e-9L);
    return static_cast<double>(m * std::sqrt(std::max(1.0L - c * c, 0.0L)) / c);
  }
};

}  // namespace pathmark::testing
