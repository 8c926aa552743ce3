// PrimitiveHit: which triangle or sphere a ray meets, and how far along.
#pragma once

#include <cstdint>

namespace pathmark {

struct PrimitiveHit {
  float t = 0.0f;
  std::uint32_t index = 0;  // of the triangle or sphere in the scene
  bool isSphere = false;
};

}  // namespace pathmark
