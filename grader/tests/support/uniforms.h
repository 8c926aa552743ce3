// Uniforms: random numbers for tests, independent of the framework's samplers.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace pathmark::testing {

// SplitMix64 (Steele, Lea & Flood, OOPSLA 2014): passes BigCrush, and every seed is a good one.
class Uniforms {
 public:
  explicit Uniforms(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15ull;
    std::uint64_t x = state_;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
  }

  // A multiple of 2^-24 in [0,1), as the framework's samplers give them.
  float next() { return static_cast<float>(bits() >> 40) * 0x1p-24f; }

  double nextDouble() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  double between(double low, double high) { return low + (high - low) * nextDouble(); }

  // Box & Muller 1958.
  double nextNormal() {
    const double radius = std::sqrt(-2.0 * std::log1p(-nextDouble()));
    return radius * std::cos(2.0 * std::numbers::pi * nextDouble());
  }

 private:
  std::uint64_t state_;
};

}  // namespace pathmark::testing
