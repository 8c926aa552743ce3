// The BRDF that stands in for Phong's where another part is checked: its value depends on both
// directions, and not symmetrically, so that an estimator that confuses wo with wi, or forgets a
// cosine, cannot hide. It says "no sample" for an eighth of its samples.
//
//   f(wo, wi) = Kd / pi (0.2 + 0.5 cos(wo)^2 + 0.4 cos(wi)),   density 7/8 / (2 pi)
#pragma once

namespace pathmark::lopsided {

// pi f / Kd, by the cosines to the normal; both positive.
template <typename T>
T shape(T cosO, T cosI) {
  return T(0.2) + T(0.5) * cosO * cosO + T(0.4) * cosI;
}

inline constexpr float kShareOfSamples = 0.875f;

}  // namespace pathmark::lopsided
