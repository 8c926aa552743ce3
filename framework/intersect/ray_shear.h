// RayShear: the shear and scaling that turn a ray into the unit vector along its largest axis.
//
// A vertex is then tested by its x and y alone (Woop, Benthin & Wald, "Watertight Ray/Triangle
// Intersection", JCGT 2(1), 2013, section 3). For a direction against that axis triangles turn the
// other way round.
#pragma once

#include <pathmark/types.h>

#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <cstdint>

namespace pathmark {

struct RayShear {
  unsigned kx, ky, kz;  // which coordinate is which
  float ox, oy, oz;     // origin
  float sx, sy;         // x -= sx z, y -= sy z

  // Without branches: the largest axis of a ray cannot be predicted, and one wrong guess costs as
  // much as eight triangles.
  RayShear(const Point& origin, const Vector& direction) {
    const float x = std::abs(direction.x), y = std::abs(direction.y), z = std::abs(direction.z);
    const unsigned order = unsigned{y >= x} | unsigned{z >= x} << 1 | unsigned{z >= y} << 2;
    // By what is at least as large as what; z is the largest only if above both others.
    static constexpr std::uint8_t kX[8] = {1, 2, 1, 2, 1, 2, 0, 0};
    static constexpr std::uint8_t kY[8] = {2, 0, 2, 0, 2, 0, 1, 1};
    static constexpr std::uint8_t kZ[8] = {0, 1, 0, 1, 0, 1, 2, 2};
    kx = kX[order];
    ky = kY[order];
    kz = kZ[order];
    const float* d = glm::value_ptr(direction);
    const float* o = glm::value_ptr(origin);
    ox = o[kx];
    oy = o[ky];
    oz = o[kz];
    const float inverse = 1.0f / d[kz];
    sx = d[kx] * inverse;
    sy = d[ky] * inverse;
  }
};

}  // namespace pathmark
