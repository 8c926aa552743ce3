// PrimitiveHit: which triangle or sphere a ray meets, and where.
#pragma once

#include <pathmark/types.h>

#include <cstdint>

namespace pathmark {

struct PrimitiveHit {
  float t = 0.0f;
  std::uint32_t index = 0;  // of the triangle or sphere in the scene
  bool isSphere = false;
  Vector barycentric{0.0f};  // of a triangle's vertices, summing to 1
};

}  // namespace pathmark
