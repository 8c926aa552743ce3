#include "preview/samples/cosine_lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pathmark::preview {

namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

double CosineLobe::density(double cosAlpha) const {
  return cosAlpha > 0.0 ? (m + 1.0) / (2.0 * kPi) * std::pow(cosAlpha, m) : 0.0;
}

double CosineLobe::massWithin(double alpha) const {
  if (alpha <= 0.0) return 0.0;
  if (alpha >= 0.5 * kPi) return 1.0;
  return -std::expm1((m + 1.0) * std::log(std::cos(alpha)));
}

double CosineLobe::angleWith(double mass) const {
  if (mass >= 1.0) return 0.5 * kPi;
  // By sin^2(alpha) = 1 - cos^2(alpha), since cos(alpha) is next to 1 for large m.
  const double sin2 = -std::expm1(2.0 * std::log1p(-mass) / (m + 1.0));
  return std::asin(std::sqrt(std::clamp(sin2, 0.0, 1.0)));
}

// Directions at the angle alpha from the lobe's axis lie all in the cone, or none of them does, or
// those at an azimuth below acos((cos(angle) - cos(alpha) cos(tilt)) / (sin(alpha) sin(tilt))).
// The share of these is integrated over the mass of the lobe; the substitution by a cosine takes
// away the square roots at the ends.
double CosineLobe::massWithinOf(double tilt, double angle) const {
  constexpr int kNodes = 64;
  if (angle <= 0.0) return 0.0;
  if (angle >= kPi) return 1.0;
  const double first = std::abs(angle - tilt),
               last = std::min(angle + tilt, 2.0 * kPi - angle - tilt);
  double mass = angle > tilt ? massWithin(first) : 0.0;
  if (angle + tilt > kPi) mass += 1.0 - massWithin(last);
  const double low = massWithin(first), high = massWithin(last);
  for (int k = 0; k < kNodes; ++k) {
    const double w = kPi * (k + 0.5) / kNodes;
    const double alpha = angleWith(low + (high - low) * 0.5 * (1.0 - std::cos(w)));
    const double across = std::sin(alpha) * std::sin(tilt);
    if (across <= 0.0) continue;
    const double cosine = (std::cos(angle) - std::cos(alpha) * std::cos(tilt)) / across;
    mass += (high - low) * 0.5 * std::sin(w) * kPi / kNodes *
            std::acos(std::clamp(cosine, -1.0, 1.0)) / kPi;
  }
  return std::clamp(mass, 0.0, 1.0);
}

// The integral over the angle is elementary, and ends at the horizon, where
// cos(alpha) cos(tilt) + sin(alpha) sin(tilt) cos(azimuth) = 0.
double diffuseMass(double tilt, const RingSector& sector) {
  constexpr int kNodes = 32;
  const double step = (sector.toAzimuth - sector.fromAzimuth) / kNodes;
  double mass = 0.0;
  for (int k = 0; k < kNodes; ++k) {
    const double lean = std::sin(tilt) * std::cos(sector.fromAzimuth + (k + 0.5) * step);
    const double horizon = std::atan2(std::cos(tilt), -lean);
    const auto integral = [&](double angle) {
      const double a = std::min(angle, horizon);
      return 0.5 * std::cos(tilt) * std::sin(a) * std::sin(a) +
             lean * (0.5 * a - 0.25 * std::sin(2.0 * a));
    };
    mass += (integral(sector.toAngle) - integral(sector.fromAngle)) * step / kPi;
  }
  return mass;
}

}  // namespace pathmark::preview
