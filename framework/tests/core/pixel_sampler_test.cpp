// What holds for every sampler: numbers in [0,1), the same for the same ray, uniform in every
// dimension, and independent between dimensions, pixels, replicates and seeds.
#include "sampling/pixel_sampler.h"
#include "stats/mean_test.h"
#include "stats/moments.h"
#include "stats/weighted_cells.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <vector>

namespace pathmark::test {
namespace {

// Chance of each statistical assertion to fail for correct samplers.
constexpr double kFalseFail = 1e-7;
constexpr std::uint32_t kRaysPerPass = 64;

class PixelSamplerTest : public ::testing::TestWithParam<SamplerKind> {
 protected:
  static std::unique_ptr<PixelSampler> sampler(std::uint64_t seed,
                                               std::uint32_t raysPerPass = kRaysPerPass) {
    return makePixelSampler(GetParam(), seed, raysPerPass);
  }
};

void expectMean(const stats::RunningMoments& moments, double expected) {
  stats::MeanTest settings;
  settings.alpha = kFalseFail;
  EXPECT_TRUE(stats::testMean(moments, expected, settings))
      << moments.mean() << " instead of " << expected;
}

TEST_P(PixelSamplerTest, NumbersAreInTheHalfOpenUnitInterval) {
  for (const std::uint32_t raysPerPass : {1u, 7u, 50u, 64u}) {
    const auto points = sampler(1, raysPerPass);
    float largest = 0.0f;
    const auto check = [&](float x) {
      ASSERT_GE(x, 0.0f);
      ASSERT_LT(x, 1.0f);
      largest = std::max(largest, x);
    };
    for (int pixel = 0; pixel < 1000; ++pixel) {
      points->startPixel(pixel, 3, 0);
      for (std::uint32_t ray = 0; ray < raysPerPass; ++ray) {
        points->startRay(static_cast<int>(ray));
        for (int k = 0; k < 40; ++k) {
          check(points->next1D());
          const vec2 pair = points->next2D();
          check(pair.x);
          check(pair.y);
        }
      }
    }
    EXPECT_GT(largest, 0.9999f);
  }
}

TEST_P(PixelSamplerTest, ARayHasTheSameNumbersWhateverCameBefore) {
  const auto one = sampler(5), two = sampler(5);
  one->startPixel(10, 20, 128);
  one->startRay(7);
  two->startPixel(3, 4, 0);
  for (int k = 0; k < 33; ++k) two->next1D();
  two->startPixel(10, 20, 128);
  for (const int other : {200, 50, 300}) {
    two->startRay(other);
    for (int k = 0; k < 40; ++k) two->next1D();
    for (int k = 0; k < 40; ++k) two->next2D();
  }
  two->startRay(7);
  for (int k = 0; k < 100; ++k) {
    EXPECT_EQ(one->next1D(), two->next1D());
    EXPECT_EQ(one->next2D(), two->next2D());
  }
}

TEST_P(PixelSamplerTest, APathWithoutAPlaceOnTheFilmHasTheNumbersThatComeAfterIt) {
  const auto ray = sampler(5), path = sampler(5);
  ray->startPixel(10, 20, 128);
  path->startPixel(10, 20, 128);
  for (const int m : {7, 8, 0}) {
    ray->startRay(m);
    path->startPath(m);
    ray->next2D();
    for (int k = 0; k < 50; ++k) {
      EXPECT_EQ(path->next2D(), ray->next2D());
      EXPECT_EQ(path->next1D(), ray->next1D());
    }
  }
}

TEST_P(PixelSamplerTest, NumbersOfALongPathDoNotRepeat) {
  const auto points = sampler(5);
  points->startPixel(1, 2, 0);
  points->startRay(9);
  std::set<std::pair<float, float>> pairs, singles;
  for (int k = 0; k < 3000; ++k) {
    const vec2 pair = points->next2D();
    pairs.insert({pair.x, pair.y});
    const float single = points->next1D();
    singles.insert({single, points->next1D()});
  }
  EXPECT_EQ(pairs.size(), 3000u);
  EXPECT_EQ(singles.size(), 3000u);
}

TEST_P(PixelSamplerTest, RaysAreCountedOverPasses) {
  const auto one = sampler(5), two = sampler(5);
  one->startPixel(10, 20, 3 * kRaysPerPass);
  two->startPixel(10, 20, kRaysPerPass);
  for (const int ray : {0, 1, 63}) {
    one->startRay(ray);
    two->startRay(ray + 2 * static_cast<int>(kRaysPerPass));
    for (int k = 0; k < 50; ++k) EXPECT_EQ(one->next2D(), two->next2D());
  }
}

TEST_P(PixelSamplerTest, SeedsPixelsPassesAndRaysHaveNumbersOfTheirOwn) {
  std::set<std::pair<float, float>> first;
  std::size_t rays = 0;
  for (const std::uint64_t seed : {0u, 1u, 2u})
    for (int pixel = 0; pixel < 16; ++pixel)
      for (const std::uint64_t pass : {0u, 1u, 5u}) {
        const auto points = sampler(seed);
        points->startPixel(pixel % 4, pixel / 4, pass * kRaysPerPass);
        for (int ray = 0; ray < 8; ++ray, ++rays) {
          points->startRay(ray);
          points->next2D();
          const vec2 pair = points->next2D();
          first.insert({pair.x, pair.y});
        }
      }
  EXPECT_EQ(first.size(), rays);
}

// Moments of single numbers and of pairs, over pixels: whichever ray it is, and however far along
// the path.
TEST_P(PixelSamplerTest, NumbersAreUniformInEveryDimension) {
  const auto points = sampler(2);
  for (const int ray : {0, 1, 37, 63}) {
    constexpr int kDimensions = 40;
    std::vector<stats::RunningMoments> mean(3 * kDimensions), square(3 * kDimensions);
    for (int pixel = 0; pixel < 20000; ++pixel) {
      points->startPixel(pixel % 200, pixel / 200, 2 * kRaysPerPass);
      points->startRay(ray);
      for (std::size_t k = 0; k < mean.size(); k += 3) {
        const vec2 pair = points->next2D();
        const float numbers[] = {points->next1D(), pair.x, pair.y};
        for (std::size_t c = 0; c < 3; ++c) {
          const auto x = static_cast<double>(numbers[c]);
          mean[k + c].add(x);
          square[k + c].add(x * x);
        }
      }
    }
    for (const stats::RunningMoments& m : mean) expectMean(m, 0.5);
    for (const stats::RunningMoments& m : square) expectMean(m, 1.0 / 3.0);
  }
}

// Two points that should know nothing of each other fall into the 16 x 16 joint cells of their
// coordinates alike. Only one ray of a pixel is looked at: those of a pixel belong together.
class JointCells {
 public:
  void add(const vec2& a, const vec2& b) {
    cells_.add((cell(a.x) * 4 + cell(a.y)) * 16 + cell(b.x) * 4 + cell(b.y));
  }

  void expectUniform(const char* what) const {
    const std::vector<double> probabilities(256, 1.0 / 256.0);
    const stats::Verdict verdict = cells_.test(probabilities, kFalseFail);
    EXPECT_TRUE(verdict.pass) << what << ": " << verdict.statistic << " > " << verdict.critical;
  }

 private:
  static std::size_t cell(float x) { return static_cast<std::size_t>(x * 4.0f); }

  stats::WeightedCells cells_{256};
};

vec2 pairOf(PixelSampler& points, int i, int j, std::uint64_t before, int ray, int dimension) {
  points.startPixel(i, j, before);
  points.startRay(ray);
  for (int k = 0; k < dimension; ++k) points.next2D();
  return points.next2D();
}

vec2 singlesOf(PixelSampler& points, int first, int second) {
  vec2 singles{};
  for (int k = 0; k <= second; ++k) {
    const float x = points.next1D();
    if (k == first) singles.x = x;
    if (k == second) singles.y = x;
  }
  return singles;
}

// The seeds of replicates are hashes, and one is that of the image.
TEST_P(PixelSamplerTest, PixelsDimensionsSeedsAndReplicatesKnowNothingOfOneAnother) {
  constexpr int kPixels = 40000;
  const auto a = sampler(3), other = sampler(4), replicate = sampler(mix(3));
  JointCells columns, rows, seeds, replicates, pairs, farPairs, film, passes, singles, farSingles,
      both;
  for (int k = 0; k < kPixels; ++k) {
    const int i = k % 400, j = k / 400 * 2, ray = 5 + k % 2;
    const vec2 u = pairOf(*a, i, j, 64, ray, 1);
    columns.add(u, pairOf(*a, i + 1, j, 64, ray, 1));
    rows.add(u, pairOf(*a, i, j + 1, 64, ray, 1));
    pairs.add(u, pairOf(*a, i, j, 64, ray, 2));
    farPairs.add(u, pairOf(*a, i, j, 64, ray, 19));
    film.add(u, pairOf(*a, i, j, 64, ray, 0));
    seeds.add(u, pairOf(*other, i, j, 64, ray, 1));
    replicates.add(u, pairOf(*replicate, i, j, 64, ray, 1));
    passes.add(pairOf(*a, i, j, 0, 0, 1), pairOf(*a, i, j, 64, 0, 1));
    a->startRay(ray);
    singles.add(u, singlesOf(*a, 0, 1));
    a->startRay(ray);
    farSingles.add(u, singlesOf(*a, 7, 19));
    a->startRay(ray);
    both.add(singlesOf(*a, 0, 8), singlesOf(*other, 0, 8));
  }
  columns.expectUniform("pixels of a row");
  rows.expectUniform("pixels of a column");
  pairs.expectUniform("pairs that follow each other");
  farPairs.expectUniform("pairs far apart");
  film.expectUniform("a pair and the place on the film");
  seeds.expectUniform("seeds");
  replicates.expectUniform("replicates");
  passes.expectUniform("the first rays of two passes");
  singles.expectUniform("a pair and singles");
  farSingles.expectUniform("a pair and singles far along");
  both.expectUniform("singles of two seeds");
}

// Also the sums over the rays of two pixels: equal errors of neighbours would be seen as stripes.
TEST_P(PixelSamplerTest, ErrorsOfNeighboursAndReplicatesAreUncorrelated) {
  const auto a = sampler(6), replicate = sampler(mix(6));
  stats::RunningMoments columns, rows, replicates, dimensions;
  const auto error = [](PixelSampler& points, int i, int j, int dimension) {
    points.startPixel(i, j, 0);
    double sum = 0.0;
    for (int ray = 0; ray < 16; ++ray) {
      points.startRay(ray);
      vec2 pair{};
      for (int k = 0; k <= dimension; ++k) pair = points.next2D();
      sum += pair.x + pair.y < 0.9f ? 1.0 - 0.405 : -0.405;
    }
    return sum;
  };
  for (int k = 0; k < 40000; ++k) {
    const int i = k % 200, j = k / 200;
    const double x = error(*a, i, j, 1);
    columns.add(x * error(*a, i + 1, j, 1));
    rows.add(x * error(*a, i, j + 1, 1));
    dimensions.add(x * error(*a, i, j, 2));
    replicates.add(x * error(*replicate, i, j, 1));
  }
  for (const stats::RunningMoments& m : {columns, rows, dimensions, replicates}) expectMean(m, 0.0);
}

// The mean over the rays of a pixel of a function of two pairs and two singles, over pixels.
TEST_P(PixelSamplerTest, EstimatesOfIntegralsOverSeveralDimensionsAreUnbiased) {
  for (const int rays : {1, 5, 64}) {
    const auto points = sampler(7, static_cast<std::uint32_t>(rays));
    stats::RunningMoments smooth, sharp;
    for (int pixel = 0; pixel < 30000; ++pixel) {
      points->startPixel(pixel % 200, pixel / 200, 0);
      double sum = 0.0, hits = 0.0;
      for (int ray = 0; ray < rays; ++ray) {
        points->startRay(ray);
        const vec2 film = points->next2D(), u = points->next2D(), v = points->next2D();
        const float s = points->next1D(), t = points->next1D();
        sum += static_cast<double>(film.x * film.y * u.x * v.y * s * t);
        hits += u.x + v.x < 1.0f && s + u.y < 1.0f ? 1.0 : 0.0;
      }
      smooth.add(sum / rays);
      sharp.add(hits / rays);
    }
    expectMean(smooth, 0x1p-6);
    expectMean(sharp, 0.25);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, PixelSamplerTest,
                         ::testing::Values(SamplerKind::kSobol, SamplerKind::kStratified,
                                           SamplerKind::kPcg),
                         [](const auto& kind) { return std::string(nameOf(kind.param)); });

}  // namespace
}  // namespace pathmark::test
