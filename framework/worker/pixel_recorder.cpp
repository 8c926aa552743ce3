#include "worker/pixel_recorder.h"

#include "sampling/mix.h"

#include <algorithm>

namespace pathmark {

PixelRecorder::PixelRecorder(const RecordPixelRequest& request)
    : kind_(request.numbers),
      constant_(request.constant),
      state_(mix(request.seed + kGolden)),
      most_(static_cast<std::size_t>(std::max(request.rays, 0)) + kExtraRecordedRays) {}

void PixelRecorder::startRay(int m) {
  startRay_ = m;
  numbers_ = 0;
  ++counts_.started;
  forgetNumbers();
}

Colour PixelRecorder::trace(const Ray& ray) {
  const std::uint32_t m = counts_.traced++;
  if (rays_.size() < most_)
    rays_.push_back({{ray.origin.x, ray.origin.y, ray.origin.z},
                     {ray.direction.x, ray.direction.y, ray.direction.z},
                     startRay_,
                     counts_.started,
                     numbers_});
  return radianceOf(m);
}

// One at a time, so that none is made that is not asked for.
void PixelRecorder::refillSingles() {
  nextSingle_ = kBlock - 1;
  singles_[nextSingle_] = number();
}

void PixelRecorder::refillPairs() {
  nextPair_ = kBlock - 1;
  pairsX_[nextPair_] = number();
  pairsY_[nextPair_] = number();
}

float PixelRecorder::number() {
  ++(counts_.started == 0 ? counts_.strayNumbers : numbers_);
  if (kind_ == RecordedNumbers::kConstant) return constant_;
  state_ += kGolden;
  return static_cast<float>(mix(state_) >> 40) * 0x1p-24f;
}

}  // namespace pathmark
