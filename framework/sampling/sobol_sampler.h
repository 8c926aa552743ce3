// SobolSampler: Owen-scrambled Sobol points, padded: every pair of dimensions of a path is a
// (0,2)-sequence of its own over the rays of the pixel.
//
// Of a (0,2)-sequence, any 2^k points in a row from a multiple of 2^k on have one in each of the
// 2^k rectangles of any of the shapes 2^-a by 2^-(k-a). The k-th pairs of the rays of a pixel are
// scrambled by keys of their own, and taken in an order of their own (Burley, "Practical Hash-based
// Owen Scrambling", JCGT 9(4), 2020, section 5), so that pairs, pixels and seeds know nothing of
// one another. Two singles share such a pair.
//
// The first pair of a ray is for its place on the film. Ray m of a pass goes into the same stratum
// in every pass, so its place within the stratum is from a sequence that belongs to m, by the
// number of the pass.
//
// After 2^32 rays of a pixel its sequences begin again, with other keys.
#pragma once

#include "sampling/pixel_sampler.h"

#include <cstdint>
#include <vector>

namespace pathmark {

class SobolSampler final : public PixelSampler {
 public:
  SobolSampler(std::uint64_t seed, std::uint32_t raysPerPass);

  void startPixel(int i, int j, std::uint64_t raysBefore) override;
  void startRay(int m) override;

 private:
  // Sequences are made side by side, as many as fit into a vector register.
  static constexpr std::uint32_t kLanes = 8;

  // Keys of kLanes sequences: of the order of the points, and of their coordinates.
  struct Keys {
    alignas(32) std::array<std::uint32_t, kLanes> order, x, y;
  };

  static Keys keysOf(std::uint64_t family, std::uint32_t firstSequence);
  static void makePoints(const Keys& keys, std::uint32_t index, float* x, float* y);

  void makeFilmPoints(std::uint32_t pass);
  void refillSingles() override;
  void refillPairs() override;

  std::uint64_t seed_;
  std::uint32_t raysPerPass_;
  std::uint64_t raysBefore_ = 0;
  std::uint64_t filmFamily_ = 0, pairFamily_ = 0, singleFamily_ = 0;
  std::array<Keys, 2> firstPairs_{};  // of as many sequences as a path mostly uses, with
  Keys firstSingles_{};               // those of singles: made once for all rays of a pass
  std::uint32_t pass_ = 0;            // that startPixel began
  std::uint32_t filmPass_ = 0;        // whose rays have their places on the film here:
  std::vector<float> filmX_, filmY_;
  std::uint32_t ray_ = 0;                          // counted over passes
  std::uint32_t pairBlock_ = 0, singleBlock_ = 0;  // the next of the ray
};

}  // namespace pathmark
