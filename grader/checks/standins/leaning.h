// The BRDF that stands in for Phong's of one exponent: it reflects equally to all sides, but its
// directions lean away from wo as those of a glossy surface do, so that their density depends on
// wo.
//
//   f(wo, wi) = Kd / pi,   density 0.9 / pi on the half of the hemisphere away from wo,
//                          density 0.1 / pi on the half around wo
#pragma once

#include <pathmark/types.h>

namespace pathmark::leaning {

inline constexpr float kExponent = 5e4f;
inline constexpr float kMirrorShare = 0.9f;
inline constexpr float kOwnShare = 1.0f - kMirrorShare;

// The part of wo along the surface.
inline Vector along(const Vector& wo, const Vector& n) { return wo - dot(wo, n) * n; }

// Of the directions, that are on wi's half. Where wo is the normal there are no halves.
inline float shareOf(const Vector& wo, const Vector& wi, const Vector& n) {
  const Vector a = along(wo, n);
  if (dot(a, a) < 1e-8f) return 0.5f;
  return dot(a, wi) <= 0.0f ? kMirrorShare : kOwnShare;
}

// The direction, or its mirror image on the other half.
inline Vector onSide(const Vector& wi, const Vector& wo, const Vector& n, bool mirror) {
  const Vector a = along(wo, n);
  if (dot(a, a) < 1e-8f || (dot(a, wi) <= 0.0f) == mirror) return wi;
  return wi - 2.0f * dot(a, wi) / dot(a, a) * a;
}

}  // namespace pathmark::leaning
