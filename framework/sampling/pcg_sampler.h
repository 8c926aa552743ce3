// PcgSampler: independent random numbers from PCG32, one stream for each ray of each pixel.
//
// M. O'Neill, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for
// Random Number Generation", 2014. The stream depends on the seed, the pixel and the number of
// the ray only, so that an image does not depend on who rendered which part of it, or when.
#pragma once

#include <pathmark/sampler.h>

#include <array>
#include <cstdint>

namespace pathmark {

class PcgSampler final : public Sampler {
 public:
  explicit PcgSampler(std::uint64_t seed) : seed_(seed) {}

  // The next rays belong to pixel (i, j), of which `raysBefore` have been made already.
  void startPixel(int i, int j, std::uint64_t raysBefore);

  void startRay(int m) override;

 private:
  void refill() override;
  void startStream(std::uint64_t ray);

  std::uint64_t seed_;
  std::uint64_t pixel_ = 0;
  std::uint64_t raysBefore_ = 0;
  std::uint64_t state_ = 0;
  std::uint64_t increment_ = 1;
  std::array<float, 16> buffer_{};
};

}  // namespace pathmark
