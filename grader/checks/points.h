// The points that sampling functions are fed with, and directions of the judge's own.
//
//   Points          Owen-scrambled Sobol points, replicate by replicate
//   Random          independent numbers
//   kEdgeNumbers    s, t, u at which formulas go wrong first
//   awkwardNormals  unit vectors on, next to and between the axes
#pragma once

#include "checks/double_frame.h"
#include "sampling/sobol_sampler.h"

#include <pathmark/types.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pathmark::checks {

inline constexpr std::array kEdgeNumbers{0.0f, 0x1p-24f, 0.5f, 1.0f - 0x1p-24f};

// Every replicate is an independent scrambling of the same net: each of its points is uniform, and
// together they are spread evenly, so that a mean over them has little error of its own.
class Points {
 public:
  Points(std::uint64_t seed, std::uint32_t pointsPerReplicate)
      : sampler_(seed, pointsPerReplicate) {}

  void start(std::uint32_t replicate) { sampler_.startPixel(static_cast<int>(replicate), 0, 0); }

  // The m-th point of the replicate; the pair and the single then follow from it.
  void point(std::uint32_t m) {
    sampler_.startRay(static_cast<int>(m));
    sampler_.next2D();  // the place on the film, which is spread over passes and not within one
  }
  vec2 pair() { return sampler_.next2D(); }
  float single() { return sampler_.next1D(); }

 private:
  SobolSampler sampler_;
};

class Random {
 public:
  explicit Random(std::uint64_t seed);

  double number();  // in [0,1)
  double between(double low, double high) { return low + (high - low) * number(); }
  int below(int n) { return static_cast<int>(number() * n); }
  float uniform();  // a float in [0,1), as coursework gets it
  std::uint32_t bits();
  Vector direction();

 private:
  std::uint64_t state_;
};

// Unit vectors on, next to and between the axes, and some at random.
std::vector<Vector> awkwardNormals(std::uint64_t seed);

}  // namespace pathmark::checks
