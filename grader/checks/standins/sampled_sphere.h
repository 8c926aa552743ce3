// Of which spheres part 2's stand-in gives points, uniform by area: those that are larger than any
// other of the path tracers' checks. All other spheres are found by rays alone.
#pragma once

#include <pathmark/shapes.h>

namespace pathmark {

inline constexpr float kSampledRadius = 64.0f;

inline bool isSampled(const Sphere& sphere) { return sphere.radius() >= kSampledRadius; }

}  // namespace pathmark
