// PixelSampler: a sampler as the framework sees it, for one pixel and pass after another.
//
//   startPixel         before each renderPixel call
//   makePixelSampler   a sampler of a kind
//
// The numbers depend on the seed, the pixel and the number of the ray only, so that an image does
// not depend on who rendered which part of it, or when.
#pragma once

#include "sampling/mix.h"
#include "sampling/sampler_kind.h"

#include <pathmark/sampler.h>

#include <cstdint>
#include <memory>

namespace pathmark {

class PixelSampler : public Sampler {
 public:
  // The next rays belong to pixel (i, j), of which earlier passes have made `raysBefore`: a
  // multiple of the rays per pass.
  virtual void startPixel(int i, int j, std::uint64_t raysBefore) = 0;

  // In place of startRay(m), for a path that needs no place on the film.
  virtual void startPath(int m) {
    startRay(m);
    next2D();
  }

 protected:
  // A number that pixels and seeds do not share.
  static std::uint64_t pixelKey(std::uint64_t seed, int i, int j) {
    const auto column = static_cast<std::uint32_t>(i), row = static_cast<std::uint32_t>(j);
    const std::uint64_t pixel = (static_cast<std::uint64_t>(row) << 32) | column;
    return mix(mix(seed + kGolden) + pixel + kGolden);
  }
};

std::unique_ptr<PixelSampler> makePixelSampler(SamplerKind kind, std::uint64_t seed,
                                               std::uint32_t raysPerPass);

}  // namespace pathmark
