// Sampler: the random numbers of one pixel.
//
//   startRay(m)   before the m-th camera ray of a pixel
//   next1D()      one number in [0,1)
//   next2D()      two numbers in [0,1)^2, to be used together
//
// A number may be 0 and is never 1; the largest is 1 - 2^-24. The numbers of one ray are used in
// the order in which they are asked for, so that the framework can put better points than those
// of a generator behind the same calls.
#pragma once

#include <pathmark/types.h>

namespace pathmark {

class Sampler {
 public:
  virtual ~Sampler() = default;

  // Starts the numbers of the m-th ray of this renderPixel call, m = 0, 1, 2, ... Rays that
  // earlier passes made for the same pixel are counted by the framework, not by the caller.
  virtual void startRay(int m) = 0;

  float next1D() {
    if (next_ == end_) refill();
    return *next_++;
  }

  vec2 next2D() {
    const float x = next1D();
    return {x, next1D()};
  }

 protected:
  // Makes [next_, end_) the following numbers of the current ray; at least one.
  virtual void refill() = 0;

  const float* next_ = nullptr;
  const float* end_ = nullptr;
};

}  // namespace pathmark
