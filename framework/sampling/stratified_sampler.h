// StratifiedSampler: correlated multi-jittered points, new ones for each pass.
//
// Every pair of dimensions of a path is a set of m x n points over the rays of a pass, one in each
// cell of an m x n grid and one in each of m n columns and rows (Kensler, "Correlated
// Multi-Jittered Sampling", Pixar TM 13-01, 2013), given to the rays in random order. Every single
// is a set of m n points, one in each of m n intervals. Where no m x n, nearly square, is the
// number of rays, some of the points are left over.
#pragma once

#include "sampling/pixel_sampler.h"

#include <cstdint>
#include <vector>

namespace pathmark {

class StratifiedSampler final : public PixelSampler {
 public:
  StratifiedSampler(std::uint64_t seed, std::uint32_t raysPerPass);

  void startPixel(int i, int j, std::uint64_t raysBefore) override;
  void startRay(int m) override;

 private:
  // Numbers with 24 binary digits, of the rays of a pass.
  using Numbers = std::vector<std::uint32_t>;
  struct Pairs {
    Numbers x, y;
  };

  void refillSingles() override;
  void refillPairs() override;
  Pairs makePairs(std::uint64_t key) const;
  Numbers makeSingles(std::uint64_t key) const;
  std::uint64_t keyOf(std::uint64_t kind, std::size_t dimension) const;

  std::uint64_t seed_;
  std::uint32_t raysPerPass_, columns_, rows_;
  std::uint64_t pixelKey_ = 0;
  std::uint64_t raysBefore_ = 0;
  std::uint64_t pass_ = 0;
  std::uint32_t ray_ = 0;              // of the pass
  std::size_t pair_ = 0, single_ = 0;  // the next of the ray
  std::vector<Pairs> pairsOfPass_;     // by dimension, as far as any ray has gone
  std::vector<Numbers> singlesOfPass_;
};

}  // namespace pathmark
