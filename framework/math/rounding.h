// Rounding of float coordinates, as lengths: how far a computed point may lie off its surface.
#pragma once

#include <pathmark/types.h>

#include <algorithm>
#include <cmath>

namespace pathmark {

// Half the distance between floats next to 1.
inline constexpr float kUnitRoundoff = 0x1p-24f;

// Points are moved off a surface by this many unit roundoffs of their largest coordinate. A point
// that was projected onto its triangle's plane lies off it by at most 24 of them: 6 of its distance
// from a corner (rounding of their difference, of the normal and of their product), one of its own,
// and 4 where it was met on the other triangle of a flat quad; a point of a sphere, by 4. The rest
// covers the rounding of the moved point and of the next intersection's translation.
inline constexpr float kOffsetRoundoffs = 32.0f;

inline float largestComponent(const Vector& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// The offset of a point that was computed from coordinates of at most this magnitude.
inline float offsetForMagnitude(float magnitude) {
  return kOffsetRoundoffs * kUnitRoundoff * magnitude;
}

}  // namespace pathmark
