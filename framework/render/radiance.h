// What may come out of a function that returns radiance.
#pragma once

#include <pathmark/types.h>

#include <cmath>

namespace pathmark {

// Finite, and at least 0, in each channel.
inline bool isRadiance(const Colour& c) {
  for (int k = 0; k < 3; ++k)
    if (!(std::isfinite(c[k]) && c[k] >= 0.0f)) return false;
  return true;
}

}  // namespace pathmark
