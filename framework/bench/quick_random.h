// QuickRandom: numbers that are random enough to choose rays by, and cost next to nothing.
#pragma once

#include <cstdint>

namespace pathmark::bench {

// xorshift64* (Vigna, "An experimental exploration of Marsaglia's xorshift generators, scrambled",
// ACM TOMS 42(4), 2016).
class QuickRandom {
 public:
  explicit QuickRandom(std::uint64_t seed) : state_((seed + 1) * 0x9e3779b97f4a7c15) {}

  std::uint32_t bits() {
    state_ ^= state_ >> 12;
    state_ ^= state_ << 25;
    state_ ^= state_ >> 27;
    return static_cast<std::uint32_t>((state_ * 0x2545f4914f6cdd1d) >> 32);
  }

  // In [0,1).
  float next() { return static_cast<float>(bits() >> 8) * 0x1p-24f; }

 private:
  std::uint64_t state_;
};

}  // namespace pathmark::bench
