// SobolSampler: Owen-scrambled Sobol points, padded: every pair of dimensions of a path is a
// (0,2)-sequence of its own over the rays of the pixel.
//
// Any 2^k rays in a row from a multiple of 2^k on have one point in each of the 2^k rectangles of
// any of the k + 1 shapes 2^-a by 2^-(k-a). The k-th pairs of the rays of a pixel are scrambled by
// keys of their own, and taken in an order of their own (Burley 2020, section 5: "shuffled
// scrambled Sobol"), so that pairs, pixels and seeds know nothing of each other. Two singles share
// one such pair.
//
// The first pair of a ray is for its place on the film. Ray m of a pass goes into the same stratum
// in every pass, so it takes its place within the stratum from a sequence that belongs to m, by the
// number of the pass.
//
// After 2^32 rays of a pixel its sequences begin again, with other keys.
#pragma once

#include "sampling/pixel_sampler.h"

#include <cstdint>

namespace pathmark {

class SobolSampler final : public PixelSampler {
 public:
  SobolSampler(std::uint64_t seed, std::uint32_t raysPerPass)
      : seed_(seed), raysPerPass_(raysPerPass) {}

  void startPixel(int i, int j, std::uint64_t raysBefore) override;
  void startRay(int m) override;

  // The key of a family of independent sequences, which are numbered.
  struct Family {
    std::uint32_t low = 0, high = 0;
  };

 private:
  void refillSingles() override;
  void refillPairs() override;

  std::uint64_t seed_;
  std::uint32_t raysPerPass_;
  Family filmFamily_, pairFamily_, singleFamily_;
  std::uint64_t raysBefore_ = 0;
  std::uint32_t ray_ = 0;                   // counted over passes
  std::uint32_t pass_ = 0, rayOfPass_ = 0;  // for the place on the film
  std::uint32_t pairsMade_ = 0, sequencesOfSingles_ = 0;
};

}  // namespace pathmark
