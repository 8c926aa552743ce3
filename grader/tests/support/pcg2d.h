// PCG2D backwards: the seed that is hashed to a given value.
#pragma once

#include <pathmark/types.h>

#include <cstdint>

namespace pathmark::testing {

// The hash is a bijection of 64 bits: every step is undone.
inline uvec2 seedOf(uvec2 hash) {
  constexpr std::uint32_t kMultiplier = 1664525u, kIncrement = 1013904223u;
  std::uint32_t inverse = 1;  // of the multiplier modulo 2^32, by Newton's iteration
  for (int i = 0; i < 5; ++i) inverse *= 2u - kMultiplier * inverse;
  for (int round = 0; round < 2; ++round) {
    hash ^= hash >> 16u;
    hash.y -= kMultiplier * hash.x;
    hash.x -= kMultiplier * hash.y;
  }
  return (hash - kIncrement) * inverse;
}

}  // namespace pathmark::testing
