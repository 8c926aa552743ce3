// Two images within a region: sums over its pixels, and whether the means differ by more than
// noise.
//
//   RegionSums    of one region, three channels
//   RegionResult  means, standard errors, z-score and p-value of one channel
//   testRegion    from the one to the other
#pragma once

#include "film/image.h"
#include "render/render_job.h"
#include "stats/pooled_variance.h"

#include <array>
#include <cstdint>

namespace pathmark {

// Replicates with which each image's variances were estimated; 0 for an image without variances,
// which counts as exact. And the pixels of its blocks whose errors may depend on each other.
struct Replicates {
  std::uint32_t a = 0, b = 0;
  std::uint32_t pixelsPerBlockOfA = 1, pixelsPerBlockOfB = 1;

  bool any() const { return a > 0 || b > 0; }
  bool both() const { return a > 0 && b > 0; }
};

// Fewer say little of the noise.
inline constexpr std::uint32_t kFewReplicates = 4;

struct RegionSums {
  std::uint64_t pixels = 0;
  std::array<double, 3> a{}, b{}, magnitude{};
  std::array<stats::PooledVariance, 3> varianceA, varianceB;

  void add(const Image& imageA, const Image& imageB, std::size_t pixel, Replicates replicates);
  void merge(const RegionSums& other);
};

struct RegionResult {
  PixelRegion region;
  int channel = 0;  // of R, G, B
  std::uint64_t pixels = 0;
  double a = 0.0, b = 0.0;            // means
  double errorA = 0.0, errorB = 0.0;  // their standard errors; 0 where unknown
  double z = 0.0;                     // (a - b) / standard error; 0 where that is unknown
  double pValue = 1.0;    // probability of a |z| at least this large if there is no difference
  double relative = 0.0;  // |a - b| over the larger of |b| and RegionTolerance::dark
  bool differs = false;
};

// What the means of a region may differ by.
struct RegionTolerance {
  double relative = 0.0;  // of the larger of |b| and `dark`
  double dark = 0.0;
  double alpha = 0.0;       // probability that the noise of equal means is called a difference
  double leastError = 0.0;  // no standard error of a difference counts as smaller
};

// Without any variances, means differ where they are further apart than the tolerance. With them,
// where what is beyond the tolerance is significant by Student's t.
//
// Assumption: the noise of pixels of different blocks is independent. That of n pixels of one block
// may be the same: the variance of their sum is at most n times the sum of their variances, which
// stands for it, and they have no more degrees of freedom than one of them. Student's t assumes
// normal noise too, and that of a path tracer is skewed: where a mean is too low, so is its
// estimated error. Therefore a pixel of R replicates counts with only max(1, (R - 1) / 8) degrees
// of freedom instead of R - 1. Measured with exponential replicates against an exact reference
// (skewness 2; 1 to 1024 pixels, R from 4 to 64), the rate of false alarms is then close to alpha
// or below for all alpha down to 1e-6; for normal noise it is lower. The price is a larger critical
// z: with 4800 tiles of 64 pixels and alpha 0.001, 6.9 instead of 5.9 for R = 4, and 6.0 instead
// of 5.6 for R = 16.
//
// A pixel of two or three replicates counts with (R - 1) / 16 only: where few paths carry much of
// the light, as on a bumpy glossy mesh, they often know nothing of it, and with twice as many
// degrees one in a hundred pairs of equal renders was said to differ at alpha 0.001. Large
// differences show all the same.
RegionResult testRegion(const RegionSums& sums, const PixelRegion& region, int channel,
                        Replicates replicates, const RegionTolerance& tolerance);

}  // namespace pathmark
