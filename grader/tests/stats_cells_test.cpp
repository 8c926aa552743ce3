// The chi-square test of weighted cells, tested.
#include "stats/cell_pools.h"
#include "stats/weighted_cells.h"
#include "tests/support/uniforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace pathmark::stats {
namespace {

using testing::Uniforms;

constexpr int kRuns = 10000;
constexpr double kSigmas = 5.0;

double rateError(double rate) { return kSigmas * std::sqrt(rate * (1 - rate) / kRuns); }

// Of kRuns: at most alpha, and not so much less that the test wastes its samples.
void expectRate(int failures, double alpha) {
  const double rate = static_cast<double>(failures) / kRuns;
  EXPECT_LE(rate, alpha + rateError(alpha));
  EXPECT_GE(rate, 0.25 * alpha - rateError(alpha));
}

// Unequal cells of [0,1): squares of equal steps. Their probabilities under q = 1.
constexpr std::size_t kCells = 12;

std::vector<double> cellProbabilities() {
  std::vector<double> probabilities;
  for (std::size_t i = 0; i < kCells; ++i)
    probabilities.push_back((2.0 * static_cast<double>(i) + 1.0) / (kCells * kCells));
  return probabilities;
}

std::size_t cellOf(double x) { return static_cast<std::size_t>(std::sqrt(x) * kCells); }

TEST(WeightedCells, FailTrueProbabilitiesAtTheDeclaredRate) {
  Uniforms random(11);
  const std::vector<double> probabilities = cellProbabilities();
  for (const double alpha : {0.1, 0.01, 0.001}) {
    int failures = 0;
    for (int run = 0; run < kRuns; ++run) {
      WeightedCells cells(kCells);
      for (int i = 0; i < 1000; ++i) cells.add(cellOf(random.nextDouble()));
      failures += cells.test(probabilities, alpha).pass ? 0 : 1;
    }
    expectRate(failures, alpha);
  }
}

// x = u^(2/3) has the density 1.5 sqrt(x), so that the weight 1/pdf is unbounded at 0; the
// mixture with the uniform density keeps it below 2.
TEST(WeightedCells, AcceptSamplesOfAnotherDensityAtTheDeclaredRate) {
  Uniforms random(12);
  const std::vector<double> probabilities = cellProbabilities();
  constexpr double kAlpha = 0.01;
  int failures = 0;
  for (int run = 0; run < kRuns; ++run) {
    WeightedCells cells(kCells);
    for (int i = 0; i < 2000; ++i) {
      const double u = random.nextDouble();
      const double x = random.nextDouble() < 0.5 ? u : std::pow(u, 2.0 / 3.0);
      cells.add(cellOf(x), 1.0 / (0.5 + 0.75 * std::sqrt(x)));
    }
    failures += cells.test(probabilities, kAlpha).pass ? 0 : 1;
  }
  expectRate(failures, kAlpha);
}

// Exactly: n samples are of three kinds, two of them of probability p, and all counts of these
// that matter are gone through.
template <typename Fails>
double exactRate(int n, double p, double negligible, Fails&& fails) {
  const double expected = n * p;
  const int most = static_cast<int>(expected + 14.0 * std::sqrt(expected)) + 60;
  const auto logFactorial = [](int k) { return std::lgamma(k + 1.0); };
  double rate = 0.0;
  for (int first = 0; first <= most; ++first)
    for (int second = 0; second <= most; ++second) {
      const double log = logFactorial(n) - logFactorial(first) - logFactorial(second) -
                         logFactorial(n - first - second) + (first + second) * std::log(p) +
                         (n - first - second) * std::log1p(-2.0 * p);
      if (log > std::log(negligible) && fails(first, second)) rate += std::exp(log);
    }
  return rate;
}

TEST(WeightedCells, FailAtMostAtTheDeclaredRateFarOut) {
  const auto addMany = [](WeightedCells& cells, int count, std::size_t cell, double weight) {
    for (int i = 0; i < count; ++i) cells.add(cell, weight);
  };
  for (const double alpha : {1e-3, 1e-7, 1e-10, 3e-13}) {
    constexpr int kSamples = 1000;
    constexpr double kP = WeightedCells::kMinExpected / kSamples;
    const double three = exactRate(kSamples, kP, 1e-5 * alpha, [&](int first, int second) {
      WeightedCells cells(3);
      addMany(cells, first, 0, 1.0);
      addMany(cells, second, 1, 1.0);
      addMany(cells, kSamples - first - second, 2, 1.0);
      return !cells.test(std::vector<double>{kP, kP, 1.0 - 2.0 * kP}, alpha).pass;
    });
    constexpr int kWeighted = 2000;
    constexpr double kHalf = 0.5 * WeightedCells::kMinExpectedWeight / kWeighted;
    const double weighted = exactRate(kWeighted, kHalf, 1e-5 * alpha, [&](int first, int second) {
      WeightedCells cells(2);
      addMany(cells, first, 0, 0.5);
      addMany(cells, second, 0, 1.5);
      addMany(cells, kWeighted - first - second, 1, 1.0);
      return !cells.test(std::vector<double>{2.0 * kHalf, 1.0 - 2.0 * kHalf}, alpha).pass;
    });
    std::printf("alpha %g: rate / alpha of three cells %.2f, of weighted samples %.2f\n", alpha,
                three / alpha, weighted / alpha);
    EXPECT_LE(three, alpha);
    EXPECT_LE(weighted, alpha);
    EXPECT_GE(three, 0.2 * alpha);
  }
}

TEST(WeightedCells, CountSamplesWithoutACell) {
  Uniforms random(13);
  const std::vector<double> half{0.25, 0.25};
  WeightedCells good(2), lost(2);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.nextDouble();
    if (x < 0.5)
      good.add(x < 0.25 ? 0 : 1);
    else
      good.addNone();
    if (x < 0.48)
      lost.add(x < 0.24 ? 0 : 1);
    else
      lost.addNone();
  }
  EXPECT_TRUE(good.test(half, 1e-7).pass);
  EXPECT_FALSE(lost.test(half, 1e-7).pass);
}

TEST(WeightedCells, FindATiltOfOnePercent) {
  Uniforms random(14);
  const std::vector<double> probabilities = cellProbabilities();
  WeightedCells straight(kCells), tilted(kCells);
  for (int i = 0; i < 2000000; ++i) {
    const double u = random.nextDouble();
    straight.add(cellOf(u));
    tilted.add(cellOf(u + 0.01 * u * (1.0 - u)));
  }
  EXPECT_TRUE(straight.test(probabilities, 1e-7).pass);
  EXPECT_FALSE(tilted.test(probabilities, 1e-7).pass);
}

TEST(WeightedCells, FailMassWhereThereIsNone) {
  WeightedCells cells(3);
  for (int i = 0; i < 1000; ++i) cells.add(static_cast<std::size_t>(i % 2));
  cells.add(2);
  EXPECT_FALSE(cells.test(std::vector<double>{0.5, 0.5, 0.0}, 1e-7).pass);
}

TEST(WeightedCells, FailWhatIsNotFiniteAndWhatIsTooLittle) {
  WeightedCells nan(2), few(2);
  for (int i = 0; i < 1000; ++i) nan.add(0, std::numeric_limits<double>::quiet_NaN());
  for (int i = 0; i < 10; ++i) few.add(0);
  EXPECT_FALSE(nan.test(std::vector<double>{0.5, 0.5}, 1e-7).pass);
  EXPECT_FALSE(few.test(std::vector<double>{0.5, 0.5}, 1e-7).pass);
}

TEST(CellPools, PutCellsOfSmallProbabilityTogether) {
  const std::vector<double> probabilities{0.01, 0.5, 0.0, 0.02, 0.02, 0.45};
  const CellPools pools(probabilities, 0.04);
  ASSERT_EQ(pools.probabilities.size(), 3u);
  EXPECT_NEAR(pools.probabilities[0], 0.05, 1e-15);
  EXPECT_EQ(pools.poolOf[0], pools.poolOf[4]);
  EXPECT_EQ(pools.poolOf[2], CellPools::kNone);
}

}  // namespace
}  // namespace pathmark::stats
