#include "sampling/corner_sampler.h"

namespace pathmark {

void CornerSampler::startPixel(int i, int j, std::uint64_t raysBefore) {
  pixelKey_ = pixelKey(seed_, i, j);
  raysBefore_ = raysBefore;
  startRay(0);
}

void CornerSampler::startRay(int m) {
  state_ = mix(pixelKey_ + (raysBefore_ + static_cast<std::uint64_t>(m) + 1) * kGolden);
  forgetNumbers();
}

float CornerSampler::number() {
  state_ += kGolden;
  return kCornerNumbers[mix(state_) % kCornerNumbers.size()];
}

void CornerSampler::refillSingles() {
  nextSingle_ = 0;
  for (float& single : singles_) single = number();
}

void CornerSampler::refillPairs() {
  nextPair_ = 0;
  for (std::size_t k = 0; k < kBlock; ++k) {
    pairsX_[k] = number();
    pairsY_[k] = number();
  }
}

}  // namespace pathmark
