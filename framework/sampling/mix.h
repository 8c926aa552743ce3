// mix: a bijective mix of 64 bits, in which every bit of the argument reaches every bit of the
// value.
#pragma once

#include <cstdint>

namespace pathmark {

// The finaliser of SplitMix64 (Steele, Lea & Flood 2014; Stafford's variant 13).
constexpr std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

// 2^64 over the golden ratio, odd: the multiples of it are spread evenly. Keeps small arguments
// away from the fixed point mix(0) = 0.
inline constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ull;

}  // namespace pathmark
