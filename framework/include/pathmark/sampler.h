// Sampler: the random numbers of one pixel.
//
//   startRay(m)   before the m-th camera ray of a pixel
//   next1D()      one number in [0,1)
//   next2D()      two numbers in [0,1)^2, to be used together
//
// A number may be 0 and is never 1; the largest is 1 - 2^-24. The numbers of one ray are used in
// the order in which they are asked for, singles and pairs each in theirs: the k-th pair of every
// ray is one set of points, spread evenly over the square, and so is the k-th single over the
// interval. A sampler belongs to one thread. Use a pair for what belongs together, such as a point
// on a light.
#pragma once

#include <pathmark/types.h>

#include <array>
#include <cstddef>

namespace pathmark {

class Sampler {
 public:
  virtual ~Sampler() = default;

  // Starts the numbers of the m-th ray of this renderPixel call, m = 0, 1, 2, ... Rays that
  // earlier passes made for the same pixel are counted by the framework, not by the caller. Numbers
  // that are taken before the first call belong to no ray.
  virtual void startRay(int m) = 0;

  float next1D() {
    if (nextSingle_ == kBlock) refillSingles();
    return singles_[nextSingle_++];
  }

  vec2 next2D() {
    if (nextPair_ == kBlock) refillPairs();
    const std::size_t k = nextPair_++;
    return {pairsX_[k], pairsY_[k]};
  }

 protected:
  static constexpr std::size_t kBlock = 16;

  // Make the following numbers of the current ray, at least one: those from nextSingle_ or
  // nextPair_ on to the end of the block, which are then given out without a virtual call.
  virtual void refillSingles() = 0;
  virtual void refillPairs() = 0;

  void forgetNumbers() { nextSingle_ = nextPair_ = kBlock; }

  std::size_t nextSingle_ = kBlock, nextPair_ = kBlock;
  alignas(64) std::array<float, kBlock> singles_{};
  alignas(64) std::array<float, kBlock> pairsX_{};
  alignas(64) std::array<float, kBlock> pairsY_{};
};

}  // namespace pathmark
