#include "sampling/pcg_sampler.h"

#include "sampling/mix.h"

namespace pathmark {

void PcgSampler::startPixel(int i, int j, std::uint64_t raysBefore) {
  const auto column = static_cast<std::uint32_t>(i), row = static_cast<std::uint32_t>(j);
  pixel_ = (static_cast<std::uint64_t>(row) << 32) | column;
  raysBefore_ = raysBefore;
  startStream(raysBefore);
}

void PcgSampler::startRay(int m) { startStream(raysBefore_ + static_cast<std::uint64_t>(m)); }

void PcgSampler::startStream(std::uint64_t ray) {
  const std::uint64_t pixelKey = mix(mix(seed_ + kGolden) + pixel_ + kGolden);
  state_ = mix(pixelKey + (ray + 1) * kGolden);
  increment_ = mix(pixelKey ^ (ray + 1)) | 1u;
  next_ = end_ = nullptr;
}

void PcgSampler::refill() {
  for (float& number : buffer_) {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ull + increment_;
    const auto shifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
    const auto rotation = static_cast<std::uint32_t>(old >> 59);
    const std::uint32_t bits = (shifted >> rotation) | (shifted << ((32u - rotation) & 31u));
    // 24 bits: 32 bits times 2^-32 can round to 1 in float.
    number = static_cast<float>(bits >> 8) * 0x1p-24f;
  }
  next_ = buffer_.data();
  end_ = next_ + buffer_.size();
}

}  // namespace pathmark
