// Comparing images: the numbers, and how often noise is called a difference or hides one.
#include "film/compare.h"
#include "stats/mean_test.h"
#include "stats/moments.h"
#include "support/test_images.h"
#include "tests/support/uniforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

namespace pathmark::test {
namespace {

using testing::Uniforms;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Rates are counted with fixed seeds. The bounds are five standard deviations of the count: other
// seeds would exceed them with a probability below 1e-6.
constexpr double kSigmas = 5.0;

double normal(Uniforms& random) { return random.nextNormal(); }
double exponential(Uniforms& random) { return -std::log1p(-random.nextDouble()) - 1.0; }
using Noise = double (*)(Uniforms&);

// As a render would store it: means of replicates with this mean and relative standard deviation.
template <typename Mean>
ImageFile noisyImage(int width, int height, int replicates, Noise noise, double deviation,
                     Uniforms& random, Mean&& mean) {
  ImageFile file;
  file.image.width = width;
  file.image.height = height;
  file.origin.replicates = static_cast<std::uint32_t>(replicates);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      for (int c = 0; c < 3; ++c) {
        const double expected = mean(column, row);
        stats::RunningMoments moments;
        for (int r = 0; r < replicates; ++r)
          moments.add(expected * (1.0 + deviation * noise(random)));
        file.image.rgb.push_back(static_cast<float>(moments.mean()));
        file.image.variance.push_back(static_cast<float>(moments.variance() / replicates));
      }
  return file;
}

// Neighbours differ in brightness, and so in noise.
double uneven(int column, int row) { return 1.0 + (column * 7 + row * 3) % 11; }

ImageFile exactImage(int width, int height) {
  ImageFile file;
  file.image.width = width;
  file.image.height = height;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      file.image.rgb.insert(file.image.rgb.end(), 3, static_cast<float>(uneven(column, row)));
  return file;
}

ImageFile fileOf(Image image, std::uint32_t replicates = 1) {
  return {std::move(image), {.replicates = replicates}};
}

enum class Reference { kNoisy, kExact };

double rateOfAlarms(Noise noise, int replicates, Reference reference, double alpha, int runs) {
  constexpr int kSide = 16;
  Uniforms random(static_cast<std::uint64_t>(11 * replicates + runs));
  const ImageFile exact = exactImage(kSide, kSide);
  int alarms = 0;
  for (int run = 0; run < runs; ++run) {
    const ImageFile a = noisyImage(kSide, kSide, replicates, noise, 1.0, random, uneven);
    const ImageFile b = reference == Reference::kExact
                            ? exact
                            : noisyImage(kSide, kSide, replicates, noise, 0.7, random, uneven);
    alarms += compareImages(a, b, {.alpha = alpha}).same ? 0 : 1;
  }
  return static_cast<double>(alarms) / runs;
}

class FalseAlarms : public ::testing::TestWithParam<std::tuple<bool, int, Reference>> {};

// 15 tests of which 5 % in all may fail; exponential noise has skewness 2.
TEST_P(FalseAlarms, AreNoMoreThanDeclared) {
  constexpr double kAlpha = 0.05;
  constexpr int kRuns = 1000;
  const auto& [skewed, replicates, reference] = GetParam();
  const double rate =
      rateOfAlarms(skewed ? exponential : normal, replicates, reference, kAlpha, kRuns);
  RecordProperty("rate", std::to_string(rate));
  EXPECT_LE(rate, kAlpha + kSigmas * std::sqrt(kAlpha * (1.0 - kAlpha) / kRuns));
  // The tests are not idle either: fewer alarms would mean that differences are overlooked.
  if (static_cast<std::uint32_t>(replicates) >= kFewReplicates) {
    EXPECT_GE(rate, kAlpha / 50.0);
  }
}

// Fifteen of sixteen replicates miss a light that brings three quarters of all.
double rarelyLit(Uniforms& random) { return random.nextDouble() < 1.0 / 16.0 ? 11.25 : -0.75; }

TEST(Compare, TwoReplicatesThatMissALightTogetherAreNoProof) {
  constexpr double kAlpha = 0.05;
  constexpr int kRuns = 400;
  EXPECT_LE(rateOfAlarms(rarelyLit, 2, Reference::kNoisy, kAlpha, kRuns),
            kAlpha + kSigmas * std::sqrt(kAlpha * (1.0 - kAlpha) / kRuns));
}

TEST(Compare, TwoReplicatesShowALargeDifference) {
  Uniforms random(5);
  const auto brighter = [](int column, int row) { return 1.5 * uneven(column, row); };
  EXPECT_FALSE(compareImages(noisyImage(64, 64, 2, exponential, 1.0, random, uneven),
                             noisyImage(64, 64, 2, exponential, 1.0, random, brighter), {})
                   .same);
}

INSTANTIATE_TEST_SUITE_P(Noise, FalseAlarms,
                         ::testing::Combine(::testing::Bool(), ::testing::Values(2, 3, 4, 16),
                                            ::testing::Values(Reference::kNoisy,
                                                              Reference::kExact)));

// Whose pixels have the same noise within blocks of 4x4.
ImageFile noisyBlocks(int width, int height, int replicates, Uniforms& random) {
  constexpr int kBlock = 4;
  ImageFile file{exactImage(width, height).image, {}};
  file.origin.replicates = static_cast<std::uint32_t>(replicates);
  file.image.variance.resize(file.image.rgb.size());
  for (int top = 0; top < height; top += kBlock)
    for (int left = 0; left < width; left += kBlock) {
      stats::RunningMoments noise;
      for (int r = 0; r < replicates; ++r) noise.add(exponential(random));
      for (int row = top; row < top + kBlock; ++row)
        for (int column = left; column < left + kBlock; ++column)
          for (int c = 0; c < 3; ++c) {
            const auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(column);
            const std::size_t at = 3 * pixel + static_cast<std::size_t>(c);
            const double expected = uneven(column, row);
            file.image.rgb[at] = static_cast<float>(expected * (1.0 + noise.mean()));
            file.image.variance[at] =
                static_cast<float>(expected * expected * noise.variance() / replicates);
          }
    }
  return file;
}

TEST(Compare, NoiseThatPixelsShareIsNoDifference) {
  constexpr double kAlpha = 0.05;
  constexpr int kRuns = 1000;
  const auto rate = [&](std::uint32_t pixelsPerBlock) {
    Uniforms random(6);
    const ImageFile exact = exactImage(32, 32);
    int alarms = 0;
    for (int run = 0; run < kRuns; ++run) {
      ImageFile noisy = noisyBlocks(32, 32, 16, random);
      noisy.origin.pixelsPerBlock = pixelsPerBlock;
      alarms += compareImages(noisy, exact, {.alpha = kAlpha}).same ? 0 : 1;
    }
    return static_cast<double>(alarms) / kRuns;
  };
  EXPECT_LE(rate(16), kAlpha + kSigmas * std::sqrt(kAlpha * (1.0 - kAlpha) / kRuns));
  EXPECT_GE(rate(16), kAlpha / 50.0);
  EXPECT_GE(rate(1), 0.5) << "which pixels are in a block makes no difference";
}

TEST(Compare, NoiseIsNoDifferenceAtTheDefaultRate) {
  Uniforms random(3);
  // 100 comparisons at a rate of 0.001 with 771 tests each: more than 5 alarms have a probability
  // of 1e-9.
  int alarms = 0;
  for (int run = 0; run < 100; ++run) {
    const ImageFile a = noisyImage(128, 128, 4, exponential, 1.0, random, uneven);
    const ImageFile b = noisyImage(128, 128, 4, exponential, 0.2, random, uneven);
    alarms += compareImages(a, b, {}).same ? 0 : 1;
  }
  EXPECT_LE(alarms, 5);
}

TEST(Compare, OnePercentInOneTileIsFoundThere) {
  Uniforms random(4);
  const auto biased = [](int column, int row) {
    const bool inTile = column >= 24 && column < 32 && row >= 8 && row < 16;
    return uneven(column, row) * (inTile ? 1.01 : 1.0);
  };
  for (int run = 0; run < 20; ++run) {
    // The standard error of a pixel is 0.5 %.
    const ImageFile a = noisyImage(64, 64, 16, normal, 0.02, random, biased);
    const ImageFile b = noisyImage(64, 64, 16, normal, 0.02, random, uneven);
    const Comparison comparison = compareImages(a, b, {});
    EXPECT_FALSE(comparison.same);
    for (const RegionResult& tile : comparison.tiles) {
      const bool inTile = tile.region.left == 24 && tile.region.top == 8;
      EXPECT_EQ(tile.differs, inTile) << tile.region.left << ", " << tile.region.top;
      EXPECT_NEAR(tile.a / tile.b, inTile ? 1.01 : 1.0, 0.005) << tile.z;
    }
  }
}

TEST(Compare, OnePercentEverywhereIsFoundInMoreNoiseByTheWholeImage) {
  Uniforms random(5);
  const auto biased = [](int column, int row) { return 1.01 * uneven(column, row); };
  const ImageFile a = noisyImage(128, 128, 16, exponential, 0.4, random, biased);
  const ImageFile b = noisyImage(128, 128, 16, exponential, 0.4, random, uneven);
  const Comparison comparison = compareImages(a, b, {});
  EXPECT_FALSE(comparison.same);
  for (const RegionResult& whole : comparison.whole) EXPECT_TRUE(whole.differs) << whole.z;
}

TEST(Compare, NumbersAreTheirDefinitions) {
  const ImageFile a = fileOf({2, 1, {1, 2, 3, 5, 4, 3}, {}, {.04f, 0, 0, .12f, 0, 0}}, 4);
  const ImageFile b = fileOf({2, 1, {1, 2, 3, 1, 0, 3}, {}, {.01f, 0, 0, .08f, 0, 0}}, 9);
  const Comparison c = compareImages(a, b, {});
  EXPECT_NEAR(c.mse, (16.0 + 16.0) / 6.0, 1e-12);
  EXPECT_NEAR(c.relativeMse, (16.0 / 1.01 + 16.0 / 0.01) / 6.0, 1e-9);
  EXPECT_EQ(c.differentValues, 2u);
  ASSERT_EQ(c.whole.size(), 3u);
  EXPECT_NEAR(c.whole[0].a, 3.0, 1e-12);
  EXPECT_NEAR(c.whole[0].b, 1.0, 1e-12);
  EXPECT_NEAR(c.whole[0].errorA, 0.2, 1e-7);
  EXPECT_NEAR(c.whole[0].errorB, 0.15, 1e-7);
  EXPECT_NEAR(c.whole[0].z, 2.0 / 0.25, 1e-5);
}

TEST(Compare, TilesCoverTheImageOnceUpToItsEdges) {
  const ImageFile a = fileOf(gradientImage(19, 11, 1e-4f), 8);
  const Comparison c = compareImages(a, a, {.tile = 8});
  ASSERT_EQ(c.tiles.size(), 3u * 2u * 3u);
  std::uint64_t pixels = 0;
  for (const RegionResult& tile : c.tiles) pixels += tile.pixels;
  EXPECT_EQ(pixels, 3u * 19u * 11u);
  EXPECT_EQ(c.tiles.back().region.left, 16);
  EXPECT_EQ(c.tiles.back().region.width, 3);
  EXPECT_EQ(c.tiles.back().region.height, 3);
}

TEST(Compare, PooledVarianceHasWelchsDegreesOfFreedom) {
  Uniforms random(6);
  stats::RunningMoments a, b;
  for (int i = 0; i < 7; ++i) a.add(random.nextNormal());
  for (int i = 0; i < 12; ++i) b.add(3.0 * random.nextNormal());
  stats::PooledVariance pooled;
  pooled.add(a.variance() / 7.0, 6.0);
  pooled.add(b.variance() / 12.0, 11.0);
  EXPECT_NEAR(pooled.degrees(), testMeans(a, b, {}).degrees, 1e-9);
}

TEST(Compare, RoundingIsNoDifferenceWhereThereIsNoNoise) {
  Image exact{8, 8, std::vector<float>(192, 17.0f), {}, std::vector<float>(192, 0.0f)};
  Image rounded = exact, other = exact;
  rounded.rgb.assign(192, std::nextafter(17.0f, 18.0f));
  other.rgb.assign(192, 17.001f);
  EXPECT_TRUE(compareImages(fileOf(rounded, 8), fileOf(exact, 8), {}).same);
  EXPECT_FALSE(compareImages(fileOf(other, 8), fileOf(exact, 8), {}).same);
}

TEST(Compare, WithoutVariancesOnlyEqualImagesAreTheSame) {
  const Image image = gradientImage(16, 16);
  Image other = image;
  other.rgb[100] = std::nextafter(other.rgb[100], 2.0f);
  EXPECT_TRUE(compareImages(fileOf(image), fileOf(image), {}).same);
  const Comparison c = compareImages(fileOf(other), fileOf(image), {});
  EXPECT_FALSE(c.same);
  EXPECT_FALSE(c.judged);
  EXPECT_EQ(c.differentValues, 1u);
}

TEST(Compare, WithinATheMeansOfTilesMayDiffer) {
  const Image image = gradientImage(16, 16);
  Image one = image, tile = image;
  for (float& value : one.rgb) value *= 1.009f;
  for (std::size_t row = 0; row < 8; ++row)
    for (std::size_t i = 0; i < 24; ++i) tile.rgb[48 * row + i] *= 1.05f;
  EXPECT_TRUE(compareImages(fileOf(one), fileOf(image), {.within = 0.01}).same);
  EXPECT_FALSE(compareImages(fileOf(one), fileOf(image), {.within = 0.008}).same);
  EXPECT_FALSE(compareImages(fileOf(tile), fileOf(image), {.within = 0.01}).same);
  EXPECT_TRUE(compareImages(fileOf(tile), fileOf(image), {.within = 0.06}).same);
}

TEST(Compare, DarkTilesAreHeldToTheMeanOfTheReference) {
  Image image{16, 8, std::vector<float>(384, 0.0f)};
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    if (i / 3 % 16 >= 8) image.rgb[i] = 1.0f;
  Image lit = image;
  // The mean is 0.5: accepted is 1 % of 1 % of it, but not more.
  lit.rgb.front() = 64.0f * 0.00004f;
  EXPECT_TRUE(compareImages(fileOf(lit), fileOf(image), {.within = 0.01}).same);
  lit.rgb.front() = 64.0f * 0.00006f;
  EXPECT_FALSE(compareImages(fileOf(lit), fileOf(image), {.within = 0.01}).same);
}

TEST(Compare, ATolerancePardonsWhatNoiseDoesNotExplain) {
  Uniforms random(8);
  const auto biased = [](int column, int row) { return 1.02 * uneven(column, row); };
  const ImageFile a = noisyImage(32, 32, 16, normal, 0.05, random, biased);
  const ImageFile b = noisyImage(32, 32, 16, normal, 0.05, random, uneven);
  EXPECT_FALSE(compareImages(a, b, {}).same);
  EXPECT_FALSE(compareImages(a, b, {.within = 0.01}).same);
  EXPECT_TRUE(compareImages(a, b, {.within = 0.03}).same);
}

// Variances of values below 1e-19 are too small for a float.
TEST(Compare, WhatIsFarTooFaintToBeSeenIsNoDifference) {
  Image image{16, 8, std::vector<float>(384, 1.0f), {}, std::vector<float>(384, 1e-4f)};
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    if (i / 3 % 16 >= 8) image.rgb[i] = image.variance[i] = 0.0f;
  Image other = image;
  const auto light = [&](float value) {
    for (std::size_t i = 0; i < other.rgb.size(); ++i)
      if (i / 3 % 16 >= 8) other.rgb[i] = value;
  };
  for (const float faint : {1e-37f, 1e-25f, 1e-9f}) {
    light(faint);
    EXPECT_TRUE(compareImages(fileOf(other, 16), fileOf(image, 16), {}).same) << faint;
  }
  light(1e-5f);
  EXPECT_FALSE(compareImages(fileOf(other, 16), fileOf(image, 16), {}).same);
}

TEST(Compare, WhatMayBeTheNoiseOfAnImageWithoutVariancesIsUndecided) {
  Uniforms random(9);
  const ImageFile reference = noisyImage(32, 32, 16, normal, 0.01, random, uneven);
  ImageFile noisy = noisyImage(32, 32, 16, normal, 0.5, random, uneven);
  EXPECT_FALSE(compareImages(noisy, reference, {}).undecided);
  noisy.image.variance.clear();
  using Two = std::pair<const ImageFile*, const ImageFile*>;
  for (const auto& [a, b] : {Two{&noisy, &reference}, Two{&reference, &noisy}}) {
    const Comparison c = compareImages(*a, *b, {});
    EXPECT_FALSE(c.same);
    EXPECT_TRUE(c.undecided);
    EXPECT_FALSE(compareImages(*a, *b, {.within = 0.001}).undecided);
    EXPECT_TRUE(compareImages(*a, *b, {.within = 0.9}).same);
  }
  noisy.image.rgb[0] = kNan;
  EXPECT_FALSE(compareImages(noisy, reference, {}).undecided);
}

TEST(Compare, AnImageWithoutVariancesIsTheSameWhereTheNoiseOfTheOtherExplainsIt) {
  Uniforms random(10);
  const Comparison c =
      compareImages(noisyImage(32, 32, 16, normal, 0.1, random, uneven), exactImage(32, 32), {});
  EXPECT_TRUE(c.same);
  EXPECT_FALSE(c.undecided);
}

TEST(Compare, PixelsWithoutAValueAreCountedLeftOutAndADifference) {
  const Image image = gradientImage(16, 16, 1e-4f);
  Image broken = image;
  broken.rgb[0] = kNan;
  broken.rgb[1] = kInfinity;
  broken.rgb[30] = -kInfinity;
  broken.variance[60] = -1.0f;
  broken.variance[90] = kNan;
  broken.invalid.assign(256, 0);
  broken.invalid[40] = 1;
  const Comparison c = compareImages(fileOf(broken, 8), fileOf(image, 8), {});
  EXPECT_FALSE(c.same);
  EXPECT_EQ(c.pixels.a.nan, 1u);
  EXPECT_EQ(c.pixels.a.infinite, 1u);
  EXPECT_EQ(c.pixels.a.noVariance, 2u);
  EXPECT_EQ(c.pixels.a.invalid, 1u);
  EXPECT_EQ(c.pixels.b.broken(), 0u);
  EXPECT_EQ(c.pixels.count, 256u - 5u);
  EXPECT_EQ(c.mse, 0.0);
  EXPECT_EQ(c.whole[0].z, 0.0);
  EXPECT_FALSE(compareImages(fileOf(broken, 8), fileOf(broken, 8), {}).same);
}

TEST(Compare, MarkedPixelsAreTheSameWhereBothAreMarked) {
  Image image = gradientImage(4, 4);
  image.invalid.assign(16, 0);
  Image marked = image;
  marked.invalid[3] = 1;
  EXPECT_TRUE(compareImages(fileOf(marked), fileOf(marked), {}).same);
  EXPECT_FALSE(compareImages(fileOf(marked), fileOf(image), {.within = 1.0}).same);
}

TEST(Compare, ImagesWithoutAnyValueDoNotCrash) {
  Image image = gradientImage(4, 4, 0.1f);
  image.rgb.assign(48, kNan);
  const Comparison c = compareImages(fileOf(image, 4), fileOf(image, 4), {.within = 0.5});
  EXPECT_FALSE(c.same);
  EXPECT_TRUE(c.tiles.empty());
}

TEST(Compare, OtherSizesAreASentence) {
  const auto compare = [] {
    compareImages(fileOf(gradientImage(4, 3)), fileOf(gradientImage(3, 4)), {});
  };
  EXPECT_NE(sentenceOf(compare).find("4x3 and 3x4"), std::string::npos);
}

}  // namespace
}  // namespace pathmark::test
