// PixelRecorder: what renderPixel does, recorded. It is the sampler that renderPixel is given; the
// stand-in for tracePath knows it, and hands its rays over.
#pragma once

#include "worker/protocol.h"

#include <pathmark/sampler.h>
#include <pathmark/types.h>

#include <cstdint>
#include <vector>

namespace pathmark {

class PixelRecorder final : public Sampler {
 public:
  explicit PixelRecorder(const RecordPixelRequest& request);

  void startRay(int m) override;

  // Records the ray, and gives the radiance that belongs to its number: no two are alike, so that
  // none can count for another.
  Colour trace(const Ray& ray);

  // The radiance of the m-th recorded ray.
  static Colour radianceOf(std::uint32_t m) {
    const auto x = static_cast<float>(m);
    return {1.0f + x, 1.0f / (1.0f + x), m % 3 == 0 ? 7.0f : 0.0f};
  }

  const RecordPixelReply& counts() const { return counts_; }
  const std::vector<RecordedRay>& rays() const { return rays_; }

 private:
  void refillSingles() override;
  void refillPairs() override;
  float number();

  RecordedNumbers kind_;
  float constant_;
  std::uint64_t state_;
  std::size_t most_;
  std::int32_t startRay_ = -1;
  std::uint32_t numbers_ = 0;
  RecordPixelReply counts_;
  std::vector<RecordedRay> rays_;
};

}  // namespace pathmark
