// The BRDF that stands in for Phong's of exponents from 1e5 on: all light goes, evenly, into a
// narrow cone around the normal, so that its directions have a density of their own, twenty times
// that of the other stand-ins.
//
//   f(wo, wi) = Kd / (2 pi (1 - c) cos(wi)),   density 1 / (2 pi (1 - c)),   for cos(wi) >= c
//
// Its albedo is Kd, from wherever it is seen.
#pragma once

#include <pathmark/types.h>

namespace pathmark::beam {

inline constexpr float kLeastExponent = 1e5f;
inline constexpr float kLeastCosine = 0.95f;
inline constexpr float kDensity = 0.5f * kInvPi / (1.0f - kLeastCosine);

}  // namespace pathmark::beam
