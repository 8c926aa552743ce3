// randomDirection: uniform over the sphere.
#pragma once

#include "bench/quick_random.h"

#include <pathmark/types.h>

#include <cmath>

namespace pathmark::bench {

inline Vector randomDirection(QuickRandom& random) {
  const float z = 2.0f * random.next() - 1.0f, phi = 2.0f * kPi * random.next();
  const float r = std::sqrt(1.0f - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

}  // namespace pathmark::bench
