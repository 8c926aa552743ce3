// The statistics of pictures, on noise whose truth is known.
#include "marking/picture_statistics.h"

#include "marking/pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pathmark::marking {

namespace {

constexpr int kSide = 64;
constexpr std::uint32_t kReplicates = 64;

// The mean of exponential replicates around `level` times `factor`, as skewed as a path tracer's,
// and what their differences tell of it.
Measured noisy(double factor, double noise, std::uint64_t seed, double rays = 1e6) {
  std::mt19937_64 random(seed);
  std::exponential_distribution<double> draw(1.0);
  Measured result{{kSide, kSide, {}, {}, {}}, rays, kReplicates};
  for (int pixel = 0; pixel < kSide * kSide; ++pixel)
    for (int c = 0; c < 3; ++c) {
      const double level = factor * (1.0 + c + pixel % kSide / static_cast<double>(kSide));
      double sum = 0.0, squares = 0.0;
      for (std::uint32_t r = 0; r < kReplicates; ++r) {
        const double x = level * (1.0 + noise * (draw(random) - 1.0));
        sum += x;
        squares += x * x;
      }
      const double n = kReplicates, mean = sum / n;
      result.image.rgb.push_back(static_cast<float>(mean));
      result.image.variance.push_back(
          static_cast<float>((squares - n * mean * mean) / (n - 1.0) / n));
    }
  return result;
}

// The same with the first channel in all three, as where everything is grey: one path's noise is in
// all of them.
Image noisyGrey(double factor, double noise, std::uint64_t seed) {
  Image image = noisy(factor, noise, seed).image;
  for (std::vector<float>* values : {&image.rgb, &image.variance})
    for (std::size_t v = 0; v < values->size(); ++v) (*values)[v] = (*values)[v - v % 3];
  return image;
}

// How many of `trials` intervals miss the truth, and how many may do so: declared is 1 %; with that
// probability more than the bound happens once in 1e6 (binomial tail, 100 trials).
constexpr int kTrials = 100, kMostMisses = 8;

template <class Make>
int misses(double truth, Make make) {
  int count = 0;
  for (int k = 0; k < kTrials; ++k) {
    const record::Estimate e = make(static_cast<std::uint64_t>(2 * k + 1));
    if (truth < e.low || truth > e.high) ++count;
    EXPECT_LE(e.low, e.value);
    EXPECT_LE(e.value, e.high);
  }
  return count;
}

}  // namespace

TEST(PictureStatistics, BiasOfASlightlyBrighterPictureIsWithinItsInterval) {
  EXPECT_LE(misses(0.02,
                   [](std::uint64_t seed) {
                     return tileBias(noisy(1.02, 0.5, seed).image, noisy(1.0, 0.5, seed + 1).image);
                   }),
            kMostMisses);
}

// Were the channels taken for independent, one interval in seven would miss: 1.5 standard
// deviations.
TEST(PictureStatistics, BiasIsWithinItsIntervalWhereTheChannelsHaveTheSameNoise) {
  // Declared is 1 %; more than 17 misses of 400 happen with that probability once in 1e6 (binomial
  // tail).
  constexpr std::uint64_t kGreyTrials = 400;
  constexpr int kMostGreyMisses = 17;
  constexpr double truth = 0.02;
  int missed = 0;
  for (std::uint64_t k = 0; k < kGreyTrials; ++k) {
    const record::Estimate e =
        tileBias(noisyGrey(1.02, 0.5, 2 * k + 1), noisyGrey(1.0, 0.5, 2 * k + 2));
    if (truth < e.low || truth > e.high) ++missed;
  }
  EXPECT_LE(missed, kMostGreyMisses);
}

TEST(PictureStatistics, NoiseAloneIsNoBias) {
  int aboveZero = 0;
  for (std::uint64_t k = 0; k < kTrials; ++k) {
    const record::Estimate e =
        tileBias(noisy(1.0, 2.0, 2 * k + 1).image, noisy(1.0, 2.0, 2 * k + 2).image);
    if (e.low > 0.0) ++aboveZero;
  }
  EXPECT_LE(aboveZero, kMostMisses);
}

TEST(PictureStatistics, AWildPixelDoesNotHideWhatTheOthersShow) {
  Image wild = noisy(1.5, 0.1, 1).image;
  wild.rgb[0] = 1e6f;
  wild.variance[0] = 1e12f;
  EXPECT_GT(tileBias(wild, noisy(1.0, 0.1, 2).image).low, 0.3);
}

TEST(PictureStatistics, ABlackPictureIsOffByItsBrightness) {
  const Measured reference = noisy(1.0, 0.1, 1);
  Image black = reference.image;
  std::fill(black.rgb.begin(), black.rgb.end(), 0.0f);
  std::fill(black.variance.begin(), black.variance.end(), 0.0f);
  EXPECT_NEAR(tileBias(black, reference.image).value, 1.0, 1e-3);
  EXPECT_NEAR(meanErrors(black, reference.image)[0].value, -1.0, 1e-6);
}

// In one tile of 64 a lamp, a hundred times as bright as the darkest, loses 6 % of its pixels.
TEST(PictureStatistics, AnEdgeOfALampIsOffByItsShareOfTheLamp) {
  Image reference = noisy(1.0, 0.0, 1).image;
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column)
      for (int c = 0; c < 3; ++c)
        reference.rgb[static_cast<std::size_t>(3 * (row * kSide + column) + c)] = 100.0f;
  Image shifted = reference;
  for (int k = 0; k < 4; ++k)
    for (std::size_t c = 0; c < 3; ++c) shifted.rgb[static_cast<std::size_t>(3 * k) + c] = 1.0f;
  const double bias = tileBias(shifted, reference).value;
  EXPECT_GT(bias, 0.002);
  EXPECT_LT(bias, 0.01);
}

TEST(PictureStatistics, MeanErrorsAreWithinTheirIntervals) {
  EXPECT_LE(misses(0.01,
                   [](std::uint64_t seed) {
                     return meanErrors(noisy(1.01, 0.5, seed).image,
                                       noisy(1.0, 0.5, seed + 1).image)[1];
                   }),
            kMostMisses);
}

TEST(PictureStatistics, EfficiencyCountsNoiseAndRays) {
  // Twice the deviation is a quarter of the efficiency; at twice the rays an eighth.
  EXPECT_LE(misses(0.125,
                   [](std::uint64_t seed) {
                     return efficiencyOver(noisy(1.0, 0.8, seed, 2e6), noisy(1.0, 0.4, seed + 1));
                   }),
            kMostMisses);
}

TEST(PictureStatistics, PValuesOfNoiseAloneAreFlat) {
  const std::vector<std::uint32_t> bins = pValueHistogram(noisy(1.0, 0.5, 1), noisy(1.0, 0.5, 2));
  double sum = 0.0;
  for (const std::uint32_t n : bins) sum += n;
  EXPECT_EQ(sum, 3.0 * kSide * kSide);
  // Skewed noise bends the ends a little.
  for (const std::uint32_t n : bins)
    EXPECT_NEAR(n / sum, 1.0 / static_cast<double>(bins.size()), 0.02);
  const std::vector<std::uint32_t> shifted =
      pValueHistogram(noisy(1.2, 0.5, 1), noisy(1.0, 0.5, 2));
  EXPECT_GT(shifted.front(), 5 * bins.front());
}

TEST(InvalidWords, TellTheShareAndTheKinds) {
  EXPECT_EQ(invalidWords({}, 1000.0), "");
  EXPECT_EQ(invalidWords({45946, 0, 0, 7}, 294912.0),
            "16 % of its values are no radiance (45946 NaN)");
  EXPECT_EQ(invalidWords({0, 1, 2, 7}, 1e6),
            "0.0003 % of its values are no radiance (1 infinite, 2 negative)");
  EXPECT_EQ(invalidWords({1000, 0, 0, 0}, 1000.0),
            "100 % of its values are no radiance (1000 NaN)");
}

}  // namespace pathmark::marking
