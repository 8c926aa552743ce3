// SobolSampler: Owen-scrambled Sobol points, padded: every pair of dimensions of a path is a
// (0,2)-sequence of its own over the rays of the pixel.
//
// Of a (0,2)-sequence, any 2^k points in a row from a multiple of 2^k on have one in each of the
// 2^k rectangles of any of the shapes 2^-a by 2^-(k-a). The k-th pairs of the rays of a pixel are
// scrambled by keys of their own, and taken in an order of their own (as in Burley, "Practical
// Hash-based Owen Scrambling", JCGT 9(4), 2020, section 5), so that pairs, pixels and seeds know
// nothing of one another. The order keeps rays together in eights and in groups: of 64, or of the
// largest power of two in a smaller pass. Two singles share such a pair.
//
// The first pair of a ray is for its place on the film. Ray m of a pass goes into the same stratum
// in every pass, so its place within the stratum is from a sequence that belongs to m, by the
// number of the pass.
//
// After 2^32 rays of a pixel its sequences begin again, with other keys.
#pragma once

#include "sampling/pixel_sampler.h"
#include "sampling/sobol_sequences.h"

#include <cstdint>
#include <vector>

namespace pathmark {

class SobolSampler final : public PixelSampler {
 public:
  SobolSampler(std::uint64_t seed, std::uint32_t raysPerPass);

  void startPixel(int i, int j, std::uint64_t raysBefore) override;
  void startRay(int m) override;
  void startPath(int m) override;

 private:
  // Independent sequences, and those that rays of the group have used so far.
  struct Family {
    std::uint64_t key = 0;
    std::vector<SobolSequences> made;
    std::uint32_t next = 0;  // which of them the ray comes to
  };

  void makeFilmPoints(std::uint32_t pass);
  void makePoint(Family& family, float* x, float* y);
  void refillSingles() override;
  void refillPairs() override;

  std::uint64_t seed_;
  std::uint32_t raysPerPass_, groupBits_;
  std::uint64_t raysBefore_ = 0;
  std::uint32_t ray_ = 0;    // counted over passes
  std::uint32_t group_ = 0;  // of the ray
  Family pairs_, pairsOfSingles_;
  std::uint32_t passBefore_ = 0;  // that startPixel began
  bool hasFilmPoints_ = false;    // since the pixel was begun
  std::uint32_t filmPass_ = 0;    // whose rays have these places on the film:
  std::uint64_t filmKey_ = 0;
  std::vector<float> filmX_, filmY_;
};

}  // namespace pathmark
