// PcgSampler: independent random numbers from PCG32, one stream for each ray of each pixel.
//
// M. O'Neill, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for
// Random Number Generation", 2014.
#pragma once

#include "sampling/pixel_sampler.h"

#include <cstdint>

namespace pathmark {

class PcgSampler final : public PixelSampler {
 public:
  explicit PcgSampler(std::uint64_t seed) : seed_(seed) {}

  void startPixel(int i, int j, std::uint64_t raysBefore) override;
  void startRay(int m) override;

 private:
  void refillSingles() override;
  void refillPairs() override;
  void startStream(std::uint64_t ray);
  float number();

  std::uint64_t seed_;
  std::uint64_t pixelKey_ = 0;
  std::uint64_t raysBefore_ = 0;
  std::uint64_t state_ = 0;
  std::uint64_t increment_ = 1;
};

}  // namespace pathmark
