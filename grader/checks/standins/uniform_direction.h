// A direction that is uniform on the hemisphere around n: the density is 1 / (2 pi) per unit solid
// angle.
#pragma once

#include <pathmark/frame.h>

#include <cmath>

namespace pathmark {

inline constexpr float kUniformDensity = 0.5f * kInvPi;

inline Vector uniformDirection(const Vector& n, float s, float t) {
  const float radius = std::sqrt(1.0f - t * t), azimuth = 2.0f * kPi * s;
  return normalize(Frame(n).toWorld({radius * std::cos(azimuth), t, radius * std::sin(azimuth)}));
}

}  // namespace pathmark
