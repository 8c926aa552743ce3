#include "sampling/pcg_sampler.h"

namespace pathmark {

namespace {

// Numbers made at once: few, since a path may end soon, and there is no gain in more.
constexpr std::size_t kMade = 8;

}  // namespace

void PcgSampler::startPixel(int i, int j, std::uint64_t raysBefore) {
  pixelKey_ = pixelKey(seed_, i, j);
  raysBefore_ = raysBefore;
  startStream(raysBefore);
}

void PcgSampler::startRay(int m) { startStream(raysBefore_ + static_cast<std::uint64_t>(m)); }

void PcgSampler::startStream(std::uint64_t ray) {
  state_ = mix(pixelKey_ + (ray + 1) * kGolden);
  increment_ = mix(pixelKey_ ^ (ray + 1)) | 1u;
  forgetNumbers();
}

float PcgSampler::number() {
  const std::uint64_t old = state_;
  state_ = old * 6364136223846793005ull + increment_;
  const auto shifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
  const auto rotation = static_cast<std::uint32_t>(old >> 59);
  const std::uint32_t bits = (shifted >> rotation) | (shifted << ((32u - rotation) & 31u));
  // 24 bits: 32 bits times 2^-32 can round to 1 in float.
  return static_cast<float>(bits >> 8) * 0x1p-24f;
}

void PcgSampler::refillSingles() {
  nextSingle_ = kBlock - kMade;
  for (std::size_t k = nextSingle_; k < kBlock; ++k) singles_[k] = number();
}

void PcgSampler::refillPairs() {
  nextPair_ = kBlock - kMade;
  for (std::size_t k = nextPair_; k < kBlock; ++k) {
    pairsX_[k] = number();
    pairsY_[k] = number();
  }
}

}  // namespace pathmark
