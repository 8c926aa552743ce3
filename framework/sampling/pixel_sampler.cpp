#include "sampling/pixel_sampler.h"

#include "sampling/corner_sampler.h"
#include "sampling/pcg_sampler.h"
#include "sampling/sobol_sampler.h"
#include "sampling/stratified_sampler.h"

namespace pathmark {

std::unique_ptr<PixelSampler> makePixelSampler(SamplerKind kind, std::uint64_t seed,
                                               std::uint32_t raysPerPass) {
  switch (kind) {
    case SamplerKind::kPcg:
      return std::make_unique<PcgSampler>(seed);
    case SamplerKind::kStratified:
      return std::make_unique<StratifiedSampler>(seed, raysPerPass);
    case SamplerKind::kCorners:
      return std::make_unique<CornerSampler>(seed);
    default:
      return std::make_unique<SobolSampler>(seed, raysPerPass);
  }
}

}  // namespace pathmark
