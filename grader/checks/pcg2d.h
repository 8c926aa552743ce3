// PCG2D (Jarzynski & Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020), there and back.
//
//   pcg2d           the hash of a seed, which is the next seed
//   seedOf          the seed that has a given hash
//   hashesBetween   how many steps lead from one seed to another
#pragma once

#include <pathmark/types.h>

#include <cstdint>

namespace pathmark::checks {

namespace pcg {
inline constexpr std::uint32_t kMultiplier = 1664525u, kIncrement = 1013904223u;
}

inline uvec2 pcg2d(uvec2 v) {
  v = v * pcg::kMultiplier + pcg::kIncrement;
  for (int round = 0; round < 2; ++round) {
    v.x += pcg::kMultiplier * v.y;
    v.y += pcg::kMultiplier * v.x;
    v ^= v >> 16u;
  }
  return v;
}

// The hash is a bijection of 64 bits: every step is undone.
inline uvec2 seedOf(uvec2 hash) {
  std::uint32_t inverse = 1;  // of the multiplier modulo 2^32, by Newton's iteration
  for (int i = 0; i < 5; ++i) inverse *= 2u - pcg::kMultiplier * inverse;
  for (int round = 0; round < 2; ++round) {
    hash ^= hash >> 16u;
    hash.y -= pcg::kMultiplier * hash.x;
    hash.x -= pcg::kMultiplier * hash.y;
  }
  return (hash - pcg::kIncrement) * inverse;
}

inline constexpr int kNoHashes = -1;  // none lead there

inline int hashesBetween(uvec2 from, uvec2 to, int most) {
  for (int hashes = 0; hashes <= most; ++hashes, from = pcg2d(from))
    if (from == to) return hashes;
  return kNoHashes;
}

}  // namespace pathmark::checks
