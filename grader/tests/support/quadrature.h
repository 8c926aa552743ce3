// Integrals in double: Gauss-Legendre, in panels where the integrand has kinks.
//
//   integrate             over an interval
//   integrateDirections   over a zone of directions, in solid angle
#pragma once

#include "checks/double_frame.h"

#include <pathmark/types.h>

#include <array>
#include <cmath>
#include <numbers>

namespace pathmark::testing {

// Nodes and weights of the 10-point rule on [-1,1] (Abramowitz & Stegun, table 25.4).
inline constexpr std::array<std::array<double, 2>, 5> kGauss10{{
    {0.148874338981631210885, 0.295524224714752870174},
    {0.433395394129247190799, 0.269266719309996355091},
    {0.679409568299024406234, 0.219086362515982043996},
    {0.865063366688984510732, 0.149451349150580593146},
    {0.973906528517171720078, 0.066671344308688137594},
}};

template <typename Function>
double integrate(Function&& f, double a, double b, int panels = 1) {
  double sum = 0.0;
  const double half = 0.5 * (b - a) / panels;
  for (int k = 0; k < panels; ++k) {
    const double middle = a + (2 * k + 1) * half;
    for (const auto& [node, weight] : kGauss10)
      sum += half * weight * (f(middle - half * node) + f(middle + half * node));
  }
  return sum;
}

using checks::DoubleFrame;

// Of f(direction) over the directions with cosine `low` to `high` to the axis.
template <typename Function>
double integrateDirections(Function&& f, const glm::dvec3& axis, double low, double high,
                           int panels) {
  const DoubleFrame frame(axis);
  return integrate(
      [&](double cosine) {
        return integrate([&](double azimuth) { return f(frame.direction(cosine, azimuth)); }, 0.0,
                         2.0 * std::numbers::pi, panels);
      },
      low, high, panels);
}

}  // namespace pathmark::testing
