// Ratios of efficiencies, tested: their intervals hold the truth as often as they say.
#include "stats/efficiency.h"
#include "tests/support/uniforms.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace pathmark::stats {
namespace {

using testing::Uniforms;

struct Estimator {
  const char* name;
  double variance;
  double (*draw)(Uniforms&);
};

const Estimator kNormal{"normal", 1.0, [](Uniforms& u) { return u.nextNormal(); }};
const Estimator kUniform{"uniform", 1.0 / 12.0, [](Uniforms& u) { return u.nextDouble(); }};
const Estimator kExponential{"exponential", 1.0,
                             [](Uniforms& u) { return -std::log1p(-u.nextDouble()); }};
const Estimator kLognormal{"lognormal", std::exp(0.25) * std::expm1(0.25),
                           [](Uniforms& u) { return std::exp(0.5 * u.nextNormal()); }};
// Normal, and 4 in 1 of 16: skewness 1.1.
const Estimator kBright{"rarely bright", 1.0 + 16.0 * 15.0 / 256.0, [](Uniforms& u) {
                          return u.nextNormal() + (u.nextDouble() < 0.0625 ? 4.0 : 0.0);
                        }};

std::vector<double> estimates(const Estimator& estimator, int count, Uniforms& random) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i) all.push_back(estimator.draw(random));
  return all;
}

TEST(EfficiencyRatio, IntervalHoldsTheTruthAsOftenAsItSays) {
  Uniforms random(1);
  constexpr double kConfidence = 0.99;
  constexpr int kRuns = 2000;
  constexpr double kMissed = 1.0 - kConfidence;
  const double error = 5.0 * std::sqrt(kMissed / kRuns);
  std::printf("missed, of %g on both sides: better than it is, worse than it is\n", kMissed);
  for (const Estimator& a : {kNormal, kUniform, kExponential, kLognormal, kBright}) {
    for (const Estimator& b : {kNormal, a}) {
      for (const int count : {64, 256}) {
        const double truth = 2.0 * b.variance / a.variance;
        int better = 0, worse = 0;
        for (int run = 0; run < kRuns; ++run) {
          const auto first = estimates(a, count, random), second = estimates(b, 256, random);
          const EfficiencyRatio ratio = efficiencyRatio({first, 1.0}, {second, 2.0}, kConfidence);
          better += truth < ratio.low ? 1 : 0;
          worse += truth > ratio.high ? 1 : 0;
        }
        std::printf("%14s of %3d against %13s of 256: %.4f %.4f\n", a.name, count, b.name,
                    static_cast<double>(better) / kRuns, static_cast<double>(worse) / kRuns);
        EXPECT_LE(static_cast<double>(worse) / kRuns, 0.5 * kMissed + error);
        EXPECT_LE(static_cast<double>(better + worse) / kRuns, kMissed + error);
      }
    }
  }
}

TEST(EfficiencyRatio, IsAboutTwoForHalfTheCost) {
  Uniforms random(2);
  const auto a = estimates(kNormal, 1024, random), b = estimates(kNormal, 1024, random);
  const EfficiencyRatio ratio = efficiencyRatio({a, 32.0}, {b, 64.0}, 0.99);
  EXPECT_LT(ratio.low, 2.0);
  EXPECT_GT(ratio.high, 2.0);
  EXPECT_LT(ratio.high / ratio.low, 1.6);
}

TEST(EfficiencyRatio, OfEstimatorsWithoutVarianceIsThatOfTheirCosts) {
  const std::vector<double> same(64, 0.5);
  const EfficiencyRatio ratio = efficiencyRatio({same, 1.0}, {same, 3.0}, 0.99, 1e-7);
  EXPECT_NEAR(ratio.low, 3.0, 1e-9);
  EXPECT_NEAR(ratio.high, 3.0, 1e-9);
}

TEST(EfficiencyRatio, OfTooFewReplicatesIsNotKnown) {
  const std::vector<double> few{1.0, 2.0}, enough{1.0, 2.0, 3.0, 5.0};
  const EfficiencyRatio ratio = efficiencyRatio({few, 1.0}, {enough, 1.0});
  EXPECT_EQ(ratio.low, 0.0);
  EXPECT_TRUE(std::isinf(ratio.high));
}

TEST(Standing, IsOpenWhereTheIntervalHoldsTheThreshold) {
  const EfficiencyRatio ratio{1.0, 0.8, 1.25};
  EXPECT_EQ(standing(ratio, 0.5), Standing::kAbove);
  EXPECT_EQ(standing(ratio, 1.0), Standing::kOpen);
  EXPECT_EQ(standing(ratio, 2.0), Standing::kBelow);
}

TEST(BandRange, HoldsTheBandsOfBothEnds) {
  constexpr std::array<double, 3> kThresholds{0.5, 0.9, 2.0};
  EXPECT_EQ(bandRange({1.0, 0.8, 1.25}, kThresholds).lowest, 1);
  EXPECT_EQ(bandRange({1.0, 0.8, 1.25}, kThresholds).highest, 2);
  EXPECT_EQ(bandRange({1.2, 1.0, 1.4}, kThresholds).lowest, 2);
  EXPECT_EQ(bandRange({1.2, 1.0, 1.4}, kThresholds).highest, 2);
}

}  // namespace
}  // namespace pathmark::stats
