// CornerSampler: the numbers that are most likely to be forgotten, in every order.
//
// Each number of a ray is 0, a denormal number, 2^-24, 1/2 or 1 - 2^-24, the largest that a sampler
// returns: which of them is random, and independent of the others. Pictures made with it mean
// nothing; but no value that comes of it may be other than a radiance.
#pragma once

#include "sampling/pixel_sampler.h"

#include <array>
#include <cstdint>
#include <limits>

namespace pathmark {

inline constexpr std::array<float, 5> kCornerNumbers{0.0f, std::numeric_limits<float>::denorm_min(),
                                                     0x1p-24f, 0.5f, 1.0f - 0x1p-24f};

class CornerSampler final : public PixelSampler {
 public:
  explicit CornerSampler(std::uint64_t seed) : seed_(seed) {}

  void startPixel(int i, int j, std::uint64_t raysBefore) override;
  void startRay(int m) override;

 private:
  void refillSingles() override;
  void refillPairs() override;
  float number();

  std::uint64_t seed_;
  std::uint64_t pixelKey_ = 0, raysBefore_ = 0, state_ = 0;
};

}  // namespace pathmark
