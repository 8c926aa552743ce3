// PCG numbers: in [0,1), the same for the same ray, independent between rays and pixels.
#include "sampling/pcg_sampler.h"
#include "stats/mean_test.h"
#include "stats/moments.h"

#include <gtest/gtest.h>

#include <set>

namespace pathmark::test {
namespace {

// Chance of each of the 85 statistical assertions to fail for a perfect generator.
constexpr double kFalseFail = 1e-7;

void expectMean(const stats::RunningMoments& moments, double expected) {
  stats::MeanTest settings;
  settings.alpha = kFalseFail;
  const stats::Verdict verdict = stats::testMean(moments, expected, settings);
  EXPECT_TRUE(verdict.pass) << moments.mean() << " instead of " << expected;
}

TEST(PcgSampler, NumbersAreInTheHalfOpenUnitInterval) {
  PcgSampler sampler(1);
  float largest = 0.0f;
  for (int pixel = 0; pixel < 100; ++pixel) {
    sampler.startPixel(pixel, 3, 0);
    for (int k = 0; k < 100000; ++k) {
      const float x = sampler.next1D();
      ASSERT_GE(x, 0.0f);
      ASSERT_LT(x, 1.0f);
      largest = std::max(largest, x);
    }
  }
  EXPECT_GT(largest, 0.999999f);
}

TEST(PcgSampler, ARayHasTheSameNumbersWhateverCameBefore) {
  PcgSampler one(5), two(5);
  one.startPixel(10, 20, 0);
  one.startRay(7);
  two.startPixel(3, 4, 0);
  for (int k = 0; k < 33; ++k) two.next1D();
  two.startPixel(10, 20, 4);
  for (int k = 0; k < 5; ++k) two.next2D();
  two.startRay(3);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(one.next1D(), two.next1D());
}

TEST(PcgSampler, SeedsPixelsAndRaysHaveStreamsOfTheirOwn) {
  std::set<float> first;
  int streams = 0;
  for (const std::uint64_t seed : {0u, 1u, 2u}) {
    PcgSampler sampler(seed);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        for (int ray = 0; ray < 8; ++ray, ++streams) {
          sampler.startPixel(i, j, 0);
          sampler.startRay(ray);
          first.insert(sampler.next1D());
        }
  }
  // Two of 384 streams begin with the same of 2^24 numbers with probability below 1%, and with
  // these seeds none does.
  EXPECT_EQ(static_cast<int>(first.size()), streams);
}

TEST(PcgSampler, NumbersAreUniformInEveryDimension) {
  PcgSampler sampler(2);
  for (int dimension = 0; dimension < 40; ++dimension) {
    stats::RunningMoments mean, square;
    for (int pixel = 0; pixel < 20000; ++pixel) {
      sampler.startPixel(pixel % 200, pixel / 200, 0);
      sampler.startRay(0);
      float x = 0.0f;
      for (int k = 0; k <= dimension; ++k) x = sampler.next1D();
      mean.add(static_cast<double>(x));
      square.add(static_cast<double>(x) * static_cast<double>(x));
    }
    expectMean(mean, 0.5);
    expectMean(square, 1.0 / 3.0);
  }
}

// Products of numbers that should know nothing of each other have the mean 1/4.
TEST(PcgSampler, NeighbouringPixelsRaysAndDimensionsAreUncorrelated) {
  PcgSampler a(3), b(3);
  stats::RunningMoments pixels, rows, rays, dimensions, seeds;
  PcgSampler other(4);
  for (int k = 0; k < 200000; ++k) {
    const int i = k % 500, j = k / 500;
    a.startPixel(i, j, 0);
    const double x = static_cast<double>(a.next1D());
    dimensions.add(x * static_cast<double>(a.next1D()));
    const auto with = [&](int column, int row, int ray) {
      b.startPixel(column, row, 0);
      b.startRay(ray);
      return x * static_cast<double>(b.next1D());
    };
    pixels.add(with(i + 1, j, 0));
    rows.add(with(i, j + 1, 0));
    rays.add(with(i, j, 1));
    other.startPixel(i, j, 0);
    seeds.add(x * static_cast<double>(other.next1D()));
  }
  for (const stats::RunningMoments& m : {pixels, rows, rays, dimensions, seeds})
    expectMean(m, 0.25);
}

}  // namespace
}  // namespace pathmark::test
