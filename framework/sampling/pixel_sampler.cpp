#include "sampling/pixel_sampler.h"

#include "sampling/pcg_sampler.h"
#include "sampling/sobol_sampler.h"

namespace pathmark {

std::unique_ptr<PixelSampler> makePixelSampler(SamplerKind kind, std::uint64_t seed,
                                               std::uint32_t raysPerPass) {
  switch (kind) {
    case SamplerKind::kPcg:
      return std::make_unique<PcgSampler>(seed);
    default:
      return std::make_unique<SobolSampler>(seed, raysPerPass);
  }
}

}  // namespace pathmark
