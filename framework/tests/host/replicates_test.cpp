// The variance that replicates tell is that of the picture.
#include "film/replicates.h"

#include "host/render_loop.h"
#include "stats/mean_test.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pathmark::test {
namespace {

// Chance of one of the statistical assertions of this file to fail a right variance.
constexpr double kFalseFail = 1e-7;

// One pixel; all its channels alike.
std::vector<FilmPixel> film(double mean, double rays) {
  return {{{mean * rays, mean * rays, mean * rays}, rays}};
}

ReplicateSums sumsOf(const std::vector<std::vector<FilmPixel>>& films) {
  ReplicateSums sums;
  for (const auto& one : films) addReplicate(sums, one);
  return sums;
}

TEST(Replicates, VarianceIsThatOfTheMeanOfTheReplicates) {
  const ReplicateSums sums = sumsOf({film(1.0, 8), film(2.0, 8), film(6.0, 8)});
  const Image image = imageFromReplicates(1, 1, sums, film(0.0, 0));
  EXPECT_EQ(image.rgb, std::vector<float>(3, 3.0f));
  // Sample variance (4 + 1 + 9) / 2 = 7.
  EXPECT_EQ(image.variance, std::vector<float>(3, 7.0f / 3.0f));
}

TEST(Replicates, SmallVarianceOfALargeMeanIsNotCancelled) {
  ReplicateSums sums;
  for (int k = 0; k < 1000; ++k) addReplicate(sums, film(1e6 + 1e-3 * (k % 2), 64));
  const Image image = imageFromReplicates(1, 1, sums, film(0.0, 0));
  // Half of the means are 1e-3 apart from the other half: (0.5e-3)^2 * 1000 / 999 / 1000.
  EXPECT_NEAR(image.variance[0] * 999.0 / 2.5e-7, 1.0, 1e-4);
}

// 16 rays have been judged by their replicates; the picture has 20.
TEST(Replicates, RaysOfAnUnfinishedReplicateCountAndLowerTheVariance) {
  const ReplicateSums sums = sumsOf({film(1.0, 8), film(3.0, 8)});
  const Image image = imageFromReplicates(1, 1, sums, film(7.0, 4));
  EXPECT_EQ(image.rgb[0], 3.0f);
  EXPECT_FLOAT_EQ(image.variance[0], 1.0f * 16.0f / 20.0f);
}

TEST(Replicates, VarianceIsLeftOutOfFewerThanTwo) {
  EXPECT_TRUE(imageFromReplicates(1, 1, {}, film(1.0, 3)).variance.empty());
  const Image image = imageFromReplicates(1, 1, sumsOf({film(1.0, 8)}), film(3.0, 8));
  EXPECT_EQ(image.rgb[0], 2.0f);
  EXPECT_TRUE(image.variance.empty());
}

TEST(Replicates, PixelsWithoutEnoughValidRaysHaveInfiniteVariance) {
  const auto two = [](double a, double b) {
    std::vector<FilmPixel> pixels = film(a, a > 0.0 ? 8 : 0);
    pixels.push_back(film(b, 8)[0]);
    return pixels;
  };
  const ReplicateSums sums = sumsOf({two(1.0, 1.0), two(0.0, 3.0)});
  const Image image = imageFromReplicates(2, 1, sums, std::vector<FilmPixel>(2));
  EXPECT_EQ(image.rgb[0], 1.0f);
  EXPECT_TRUE(std::isinf(image.variance[0]));
  EXPECT_EQ(image.variance[3], 1.0f);
}

TEST(Replicates, WhatIsKeptDoesNotGrowWithTheirNumber) {
  ReplicateSums sums;
  for (int k = 0; k < 1024; ++k) addReplicate(sums, std::vector<FilmPixel>(6));
  EXPECT_EQ(sums.film.size(), 6u);
  EXPECT_EQ(sums.moments.size(), 6u);
}

RenderedImage render(WorkerProcess& worker, std::uint64_t rays, std::uint32_t replicates,
                     std::uint64_t seed = 0) {
  RenderSettings settings;
  settings.width = settings.height = 24;
  settings.raysPerPixel = rays;
  settings.replicates = replicates;
  settings.threads = 2;
  settings.seed = seed;
  return renderImage(worker, settings, [](const RenderStatus&) { return true; });
}

TEST(Replicates, ThePictureIsTheMeanOfIndependentOnes) {
  TestCoursework coursework;
  const auto worker = coursework.start();
  worker->loadScene(emptyScene(24, 24));
  const Image both = render(*worker, 200, 2, 5).image;
  const Image first = render(*worker, 100, 1, 5).image,
              second = render(*worker, 100, 1, replicateSeed(5, 1)).image;
  EXPECT_TRUE(first.variance.empty());
  ASSERT_EQ(both.variance.size(), both.rgb.size());
  for (std::size_t i = 0; i < both.rgb.size(); ++i) {
    const float a = first.rgb[i], b = second.rgb[i];
    EXPECT_NEAR(both.rgb[i], 0.5f * (a + b), 1e-6f);
    EXPECT_NEAR(both.variance[i], 0.25f * (a - b) * (a - b), 1e-6f);
  }
}

// Each pass is stratified in one dimension, as in part 1: m + u over n is uniform in one of n
// strata, and the mean of a pass of n rays has the variance 1 / (12 n^3), far below the 1 / (12 n)
// of independent rays. Only replicates know.
void stratify(TestCoursework& coursework) {
  coursework.setFile("part1_stratified.cpp",
                     "Ray SimpleCamera::StratifiedRandomRay(int, int, int, int, int, float,\n"
                     "                                      float) const { return {}; }\n"
                     "Colour LitScene::renderPixel(int, int, const SimpleCamera&, int n,\n"
                     "                             Sampler& sampler) const {\n"
                     "  float sum = 0.0f, product = 0.0f;\n"
                     "  for (int m = 0; m < n; ++m) {\n"
                     "    sampler.startRay(m);\n"
                     "    const vec2 u = sampler.next2D();\n"
                     "    const float x = (static_cast<float>(m) + u.x) / static_cast<float>(n);\n"
                     "    sum += x;\n    product += 16.0f * x * u.y * u.y * u.y;\n  }\n"
                     "  return Colour(sum, product, 1.0f) / static_cast<float>(n);\n}");
}

TEST(Replicates, StoredVarianceIsThatOfAClosedForm) {
  TestCoursework coursework;
  stratify(coursework);
  const auto worker = coursework.start();
  worker->loadScene(emptyScene(24, 24));
  constexpr std::uint32_t kRays = 8, kReplicates = 8;
  stats::RunningMoments stored;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Image image = render(*worker, kRays * kReplicates, kReplicates, seed).image;
    for (std::size_t i = 0; i < image.variance.size(); i += 3) {
      stored.add(image.variance[i]);
      ASSERT_EQ(image.variance[i + 2], 0.0f) << "a constant";
    }
  }
  const double expected = 1.0 / (12.0 * kRays * kRays * kRays) / kReplicates;
  // Values of a pass are floats of about 0.5: their rounding is far below the deviation 1e-2.
  const stats::MeanTest test{.alpha = kFalseFail, .tolerance = 1e-6 * expected};
  EXPECT_TRUE(stats::testMean(stored, expected, test)) << stored.mean() << " " << expected;
  EXPECT_LT(stats::smallestError(stored, test), 0.1 * expected) << "the test could see an error";
}

// Of a skewed integrand that has no simple form: pixels are independent, and for each the mean of
// the stored variances and the sample variance of the values over many seeds have the same
// expectation.
TEST(Replicates, StoredVarianceIsThatOfPicturesWithOtherSeeds) {
  TestCoursework coursework;
  stratify(coursework);
  const auto worker = coursework.start();
  worker->loadScene(emptyScene(24, 24));
  constexpr int kSeeds = 40;
  std::vector<stats::RunningMoments> values(576), variances(576);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Image image = render(*worker, 30, 6, seed).image;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i].add(image.rgb[3 * i + 1]);
      variances[i].add(image.variance[3 * i + 1]);
    }
  }
  stats::RunningMoments differences, variance;
  for (std::size_t i = 0; i < values.size(); ++i) {
    differences.add(variances[i].mean() - values[i].variance());
    variance.add(values[i].variance());
  }
  const stats::MeanTest test{.alpha = kFalseFail};
  EXPECT_TRUE(stats::testMean(differences, 0.0, test)) << differences.mean();
  EXPECT_LT(stats::smallestError(differences, test), 0.1 * variance.mean());
}

TEST(Replicates, HaveTheSameBitsForAnyNumberOfThreads) {
  TestCoursework coursework;
  const auto worker = coursework.start();
  worker->loadScene(emptyScene(37, 21));
  RenderSettings settings;
  settings.width = 37;
  settings.height = 21;
  settings.raysPerPixel = 400;
  settings.replicates = 4;
  const auto all = [](const RenderStatus&) { return true; };
  const RenderedImage one = renderImage(*worker, settings, all);
  settings.threads = 5;
  const RenderedImage five = renderImage(*worker, settings, all);
  EXPECT_EQ(one.image.rgb, five.image.rgb);
  EXPECT_EQ(one.image.variance, five.image.variance);
}

}  // namespace
}  // namespace pathmark::test
