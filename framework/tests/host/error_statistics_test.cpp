// What bench error computes: intervals that hold what they say, slopes, errors of images.
//
// Coverage is counted over 4000 made-up experiments with a fixed seed; with another seed a count
// would be outside of the bounds here, 6 standard deviations, once in 5e8 runs.
#include "bench/error_statistics.h"
#include "bench/image_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace pathmark::bench {
namespace {

constexpr int kExperiments = 4000;
// 6 standard deviations of a share of 0.95 among them.
constexpr double kOff = 6.0 * 0.00345;

double meanOver(const std::vector<double>& values, std::span<const std::size_t> chosen) {
  double sum = 0.0;
  for (const std::size_t k : chosen) sum += values[k];
  return sum / static_cast<double>(chosen.size());
}

TEST(ErrorStatistics, TheIntervalOfAMeanHoldsItInNineteenOfTwentyExperiments) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal(3.0, 0.5);
  int held = 0;
  for (int k = 0; k < kExperiments; ++k) {
    std::vector<double> values(5);
    for (double& v : values) v = normal(random);
    const Interval i =
        jackknife(values.size(), [&](auto chosen) { return meanOver(values, chosen); });
    held += i.low <= 3.0 && 3.0 <= i.high ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(held) / kExperiments, 0.95, kOff);
}

TEST(ErrorStatistics, TheErrorOfAMeanIsItsStandardError) {
  const std::vector<double> values{1.0, 2.0, 3.0};
  const auto mean = [&](auto chosen) { return meanOver(values, chosen); };
  const Interval found = jackknife(values.size(), mean);
  EXPECT_NEAR(found.error, 1.0 / std::sqrt(3.0), 1e-12);
  // Student's t with 2 degrees of freedom.
  EXPECT_NEAR(found.high - found.value, 4.302653 * found.error, 1e-6);
  EXPECT_TRUE(std::isnan(jackknife(1, mean).error)) << "of one";
}

// Errors are never negative and skewed: the interval of their logarithm may hold a little less.
TEST(ErrorStatistics, TheIntervalOfAnErrorHoldsItAlmostAsOften) {
  std::mt19937_64 random(2);
  std::gamma_distribution<double> gamma(10.0, 0.1);  // mean 1, coefficient of variation 0.32
  int held = 0;
  for (int k = 0; k < kExperiments; ++k) {
    std::vector<double> values(8);
    for (double& v : values) v = gamma(random);
    const Interval i = exponential(
        jackknife(values.size(), [&](auto chosen) { return logOfMean(values, chosen); }));
    held += i.low <= 1.0 && 1.0 <= i.high ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(held) / kExperiments, 0.95, kOff + 0.01);
}

// error = time^slope, both with noise, at four numbers of rays.
double coverageOfSlope(double truth, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  int held = 0;
  for (int k = 0; k < kExperiments; ++k) {
    std::vector<std::vector<double>> times(4, std::vector<double>(6)), errors = times;
    for (std::size_t point = 0; point < 4; ++point)
      for (std::size_t r = 0; r < 6; ++r) {
        const double time = std::pow(4.0, static_cast<double>(point));
        times[point][r] = time * std::exp(0.02 * normal(random));
        errors[point][r] = std::pow(time, truth) * std::exp(0.1 * normal(random));
      }
    const Interval i = jackknife(6, [&](auto chosen) {
      std::vector<double> x, y;
      for (std::size_t point = 0; point < 4; ++point) {
        x.push_back(logOfMean(times[point], chosen));
        y.push_back(logOfMean(errors[point], chosen));
      }
      return slope(x, y);
    });
    held += i.low <= truth && truth <= i.high ? 1 : 0;
  }
  return static_cast<double>(held) / kExperiments;
}

TEST(ErrorStatistics, TheIntervalOfASlopeHoldsIt) {
  EXPECT_NEAR(coverageOfSlope(-1.0, 3), 0.95, kOff);
  EXPECT_NEAR(coverageOfSlope(-1.5, 4), 0.95, kOff);
}

TEST(ErrorStatistics, ASlopeThroughPointsOnALineIsThatOfTheLine) {
  const std::vector<double> x{0.0, 1.0, 3.0}, y{5.0, 3.5, 0.5};
  EXPECT_DOUBLE_EQ(slope(x, y), -1.5);
  const std::vector<double> holed{5.0, std::nan(""), 0.5};
  EXPECT_DOUBLE_EQ(slope(x, holed), -1.5) << "a point that is not known is left out";
  EXPECT_TRUE(std::isnan(slope(std::vector{1.0}, std::vector{1.0})));
}

TEST(ErrorStatistics, OneReplicateHasAValueAndNoInterval) {
  const std::vector<double> values{2.0};
  const Interval i = jackknife(1, [&](auto chosen) { return meanOver(values, chosen); });
  EXPECT_EQ(i.value, 2.0);
  EXPECT_TRUE(std::isnan(i.low));
  EXPECT_TRUE(std::isnan(i.high));
}

TEST(ErrorStatistics, AnErrorBelowTheReferencesOwnHasNoLogarithm) {
  const std::vector<double> values{-1.0, 0.5};
  const std::vector<std::size_t> both{0, 1};
  EXPECT_TRUE(std::isnan(logOfMean(values, both)));
}

TEST(ErrorStatistics, WhatAllReplicatesHaveInCommonWidensTheInterval) {
  const std::vector<double> same{1.0, 1.0, 1.0};
  const auto mean = [&](auto chosen) { return meanOver(same, chosen); };
  EXPECT_EQ(jackknife(3, mean).high, 1.0);
  EXPECT_NEAR(jackknife(3, mean, 0.1).high, 1.0 + 4.3027 * 0.1, 1e-4);
}

// A grey image of radiance 0.5 with noise of this standard deviation.
Image noisy(int side, double noise, std::mt19937_64& random) {
  std::normal_distribution<double> normal(0.5, noise);
  Image image{side, side};
  image.rgb.resize(static_cast<std::size_t>(3 * side * side));
  for (float& v : image.rgb) v = static_cast<float>(normal(random));
  return image;
}

// The standard deviation of the mean of 49152 squares of a normal number is 0.64 % of it: 6 of
// them. The reference's noise is small beside the radiance: it is also in the weights 1/(r^2 +
// 0.01).
TEST(ImageError, TheReferencesOwnErrorDoesNotCount) {
  std::mt19937_64 random(5);
  Image reference = noisy(128, 0.003, random);
  reference.variance.assign(reference.rgb.size(), 0.003f * 0.003f);
  const Deviation d = deviationOf(noisy(128, 0.002, random), reference);
  EXPECT_NEAR(d.mse, 0.002 * 0.002, 0.0384 * (0.002 * 0.002 + 0.003 * 0.003));
  EXPECT_NEAR(d.relativeMse, d.mse / 0.26, 0.02 * d.mse / 0.26);
  const OwnDeviation own = ownDeviation(reference, 16);
  EXPECT_NEAR(own.relativeMse, 0.003 * 0.003 / 0.26, 0.02 * own.relativeMse);
  EXPECT_GT(own.relativeMseError, 0.0);
  EXPECT_LT(own.relativeMseError, 0.02 * own.relativeMse);
}

TEST(ImageError, TheWorstShareTellsAFireflyFromNoise) {
  std::mt19937_64 random(6);
  Image reference = noisy(64, 0.0, random);
  Image image = noisy(64, 0.02, random);
  // Five of 4096 pixels: chi-square tails, a few times their part.
  EXPECT_LT(deviationOf(image, reference).worstShare, 0.01);
  EXPECT_GT(deviationOf(image, reference).worstShare, 0.001);
  image.rgb[3 * 77] = 400.0f;
  EXPECT_GT(deviationOf(image, reference).worstShare, 0.99);
}

TEST(ImageError, EqualImagesHaveNone) {
  std::mt19937_64 random(7);
  const Image image = noisy(8, 0.1, random);
  const Deviation d = deviationOf(image, image);
  EXPECT_EQ(d.mse, 0.0);
  EXPECT_EQ(d.relativeMse, 0.0);
  EXPECT_EQ(d.worstShare, 0.0);
  EXPECT_EQ(d.mean, 0.0);
}

}  // namespace
}  // namespace pathmark::bench
