// RayShear: the shear and scaling that turn a ray into the unit vector along its largest axis.
//
// A vertex is then tested by its x and y alone (Woop, Benthin & Wald, "Watertight Ray/Triangle
// Intersection", JCGT 2(1), 2013, section 3). x and y are exchanged for negative directions, so
// that triangles keep their orientation.
#pragma once

#include <pathmark/types.h>

#include <glm/gtc/type_ptr.hpp>

#include <bit>
#include <cmath>
#include <cstdint>

namespace pathmark {

struct RayShear {
  unsigned kx, ky, kz;  // which coordinate is which
  float ox, oy, oz;     // origin
  float sx, sy, sz;     // x -= sx z, y -= sy z, z *= sz

  // Without branches: the largest axis of a ray cannot be predicted, and one wrong guess costs as
  // much as eight triangles.
  RayShear(const Point& origin, const Vector& direction) {
    const float x = std::abs(direction.x), y = std::abs(direction.y), z = std::abs(direction.z);
    static constexpr std::uint8_t kLargest[8] = {0, 1, 0, 1, 0, 1, 2, 2};  // z only if above both
    kz = kLargest[unsigned{y >= x} | unsigned{z >= x} << 1 | unsigned{z >= y} << 2];
    const float* d = glm::value_ptr(direction);
    const float* o = glm::value_ptr(origin);
    static constexpr std::uint8_t kOthers[2][4] = {{1, 2, 0, 0}, {2, 0, 1, 0}};
    const unsigned negative = std::bit_cast<std::uint32_t>(d[kz]) >> 31;
    kx = kOthers[negative][kz];
    ky = kOthers[1 - negative][kz];
    ox = o[kx];
    oy = o[ky];
    oz = o[kz];
    sz = 1.0f / d[kz];
    sx = d[kx] * sz;
    sy = d[ky] * sz;
  }
};

}  // namespace pathmark
