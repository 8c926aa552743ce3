// The pixels that are asked for in the checks of part 1, and the checks with a file of their own.
#pragma once

#include "checks/check.h"
#include "checks/part1_checks.h"
#include "checks/pixel_question.h"

#include <array>

namespace pathmark::checks {

inline constexpr std::array kRayCounts{1, 4, 9, 16, 64, 2, 3, 5, 8, 17, 24, 63, 255, 256, 1000};

inline constexpr const char* kRoundedUp = "n is rounded up: it is the largest n with n * n <= N";

// `place` as by PixelQuestion::placeOf.
inline bool isInPixel(const glm::dvec2& place, double tolerance) {
  return place.x >= -tolerance && place.y >= -tolerance && place.x <= 1.0 + tolerance &&
         place.y <= 1.0 + tolerance;
}

inline PixelQuestion somePixel(std::size_t camera, int rays, std::uint64_t seed) {
  return {.camera = filmCameras()[camera], .i = 5, .j = 2, .rays = rays, .seed = seed};
}

Finding raysAreStartedInOrder(CheckRun& run);  // "rays"
Finding raysAreEven(CheckRun& run);            // "even"

}  // namespace pathmark::checks
