// The BRDF that stands in for Phong's where another part is checked: its value depends on both
// directions, and not symmetrically, so that an estimator that confuses wo with wi, or forgets a
// cosine, cannot hide. It says "no sample" for an eighth of its samples: of all u, whatever s and t
// are, but never for a u that is s or t again.
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

// Of the last eighths of [0,1) the first that holds neither s nor t means "no sample". All of them
// are beyond the u with which the roulette's stand-in lets paths survive, so that a roulette with
// the same u shows too.
inline bool isSample(float s, float t, float u) {
  constexpr float kShareOfNone = 1.0f - kShareOfSamples;
  float first = 1.0f - 3.0f * kShareOfNone;
  const auto isIn = [&](float x) { return x >= first && x < first + kShareOfNone; };
  while (isIn(s) || isIn(t)) first += kShareOfNone;
  return !isIn(u);
}

}  // namespace pathmark::lopsided
