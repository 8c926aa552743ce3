// The replicate test, tested: how often it fails a true mean, finds a wrong one, and says neither.
#include "stats/replicate_test.h"
#include "tests/support/uniforms.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace pathmark::stats {
namespace {

using testing::Uniforms;

constexpr double kSigmas = 5.0;  // of the rates below; the seeds are fixed
constexpr std::array<int, 3> kCounts{64, 256, 1024};

double rateError(double rate, int runs) { return kSigmas * std::sqrt(rate * (1 - rate) / runs); }

template <typename Draw>
Judgement judgeInStages(double expected, const Guarantee& guarantee, Draw&& draw) {
  ReplicateTest test(expected, 0.0, guarantee);
  Judgement judgement;
  for (int look = 0; look < guarantee.looks; ++look) {
    while (test.replicates().count() < kCounts[static_cast<std::size_t>(look)]) test.add(draw());
    judgement = test.judge(look);
    if (judgement.outcome != Outcome::kUndecided) break;
  }
  return judgement;
}

// Never passes: all looks are taken.
template <typename Draw>
void expectFailsWithin(double alpha, const char* name, double mean, int runs, Draw&& draw) {
  int fails = 0;
  for (int run = 0; run < runs; ++run)
    if (judgeInStages(mean, {.alpha = alpha}, draw).outcome == Outcome::kFail) ++fails;
  const double rate = static_cast<double>(fails) / runs;
  std::printf("%-28s alpha %g, measured %g\n", name, alpha, rate);
  EXPECT_LE(rate, alpha + rateError(alpha, runs)) << name;
}

TEST(ReplicateTest, FailsTrueMeansAtMostAtTheDeclaredRateOverAllLooks) {
  Uniforms random(1);
  constexpr double kAlpha = 1e-2;
  const auto normal = [&] { return random.nextNormal(); };
  expectFailsWithin(kAlpha, "normal", 0.0, 5000, normal);
  const auto exponential = [&] { return -std::log1p(-random.nextDouble()); };
  const auto meanOf = [](int points, auto& point) {
    return [points, &point] {
      double sum = 0.0;
      for (int i = 0; i < points; ++i) sum += point();
      return sum / points;
    };
  };
  expectFailsWithin(kAlpha, "16 exponential points", 1.0, 500, meanOf(16, exponential));
  const auto lognormal = [&] { return std::exp(random.nextNormal()); };
  expectFailsWithin(kAlpha, "100 lognormal points", std::exp(0.5), 100, meanOf(100, lognormal));
  const auto rare = [&] { return random.nextDouble() < 0.02 ? 1.0 : 0.0; };
  expectFailsWithin(kAlpha, "200 points, 1 in 50 lit", 0.02, 200, meanOf(200, rare));
  const auto bright = [&] {
    return random.nextDouble() + (random.nextDouble() < 0.001 ? 3.0 : 0.0);
  };
  expectFailsWithin(kAlpha, "200 points, 1 in 1000 bright", 0.503, 200, meanOf(200, bright));
}

// With an error of delta, and a deviation at which the looks can just decide.
TEST(ReplicateTest, PassesAnErrorOfDeltaAtMostAtTheDeclaredRate) {
  Uniforms random(2);
  constexpr double kPower = 0.99;
  constexpr int kRuns = 2000;
  constexpr Guarantee kGuarantee{.alpha = 1e-6, .tolerance = 0.1, .delta = 1.0, .power = kPower};
  for (const double deviation : {0.4, 0.7, 1.4, 1.5, 1.6, 2.8, 3.0, 3.2}) {
    std::array<int, 3> outcomes{};
    for (int run = 0; run < kRuns; ++run) {
      const Judgement judgement =
          judgeInStages(5.0, kGuarantee, [&] { return 6.0 + deviation * random.nextNormal(); });
      ++outcomes[static_cast<std::size_t>(judgement.outcome)];
    }
    std::printf("deviation %.1f: passed %d, failed %d, undecided %d of %d\n", deviation,
                outcomes[0], outcomes[1], outcomes[2], kRuns);
    EXPECT_LE(outcomes[0], kRuns * (1.0 - kPower + rateError(1.0 - kPower, kRuns)));
  }
}

TEST(ReplicateTest, DecidesClearCasesAtTheFirstLook) {
  Uniforms random(3);
  constexpr Guarantee kGuarantee{.delta = 0.01};
  const auto draw = [&] { return 1.0 + 0.003 * random.nextNormal(); };
  const Judgement right = judgeInStages(1.0, kGuarantee, draw);
  EXPECT_EQ(right.outcome, Outcome::kPass);
  EXPECT_EQ(right.look, 0);
  EXPECT_LE(right.shown, 0.01);
  const Judgement wrong = judgeInStages(1.01, kGuarantee, draw);
  EXPECT_EQ(wrong.outcome, Outcome::kFail);
  EXPECT_EQ(wrong.look, 0);
  EXPECT_LT(wrong.pValue, kGuarantee.alpha / kGuarantee.looks);
}

TEST(ReplicateTest, ReportsWhatItHasShownWhereItIsUndecided) {
  Uniforms random(4);
  const Judgement judgement =
      judgeInStages(1.0, {.delta = 0.01}, [&] { return 1.0 + 0.1 * random.nextNormal(); });
  EXPECT_EQ(judgement.outcome, Outcome::kUndecided);
  EXPECT_EQ(judgement.replicates, 1024);
  EXPECT_NEAR(judgement.shown, 0.1 / 32.0 * (7.2 + 3.4), 0.1 / 32.0);
}

TEST(ReplicateTest, NeverFailsFewReplicatesUnlessTheyAreNotFinite) {
  ReplicateTest test(1.0, 0.0, {.delta = 0.1});
  for (int i = 0; i < ReplicateTest::kMinReplicates - 1; ++i) test.add(2.0);
  EXPECT_EQ(test.judge(2).outcome, Outcome::kUndecided);
  test.add(2.0);
  EXPECT_EQ(test.judge(2).outcome, Outcome::kFail) << "an error without variance";
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    ReplicateTest one(1.0, 0.0, {.delta = 0.1});
    one.add(bad);
    EXPECT_EQ(one.judge(0).outcome, Outcome::kFail);
  }
}

TEST(ReplicateTest, LeavesRoundingToTheFloorAndTheTolerance) {
  const auto judged = [](const Guarantee& guarantee) {
    ReplicateTest test(1.0, 0.0, guarantee);
    for (int i = 0; i < 128; ++i) test.add(1.0 + 1e-9);
    return test.judge(0).outcome;
  };
  EXPECT_EQ(judged({.delta = 1e-3}), Outcome::kFail);
  EXPECT_EQ(judged({.delta = 1e-3, .deviationFloor = 1e-8}), Outcome::kPass);
  EXPECT_EQ(judged({.tolerance = 1e-8, .delta = 1e-3}), Outcome::kPass);
  EXPECT_EQ(judged({.tolerance = 1e-8, .delta = 1e-9}), Outcome::kUndecided)
      << "an error that is accepted cannot be found";
}

TEST(ReplicateTest, CountsTheErrorOfTheExpectedValue) {
  Uniforms random(5);
  ReplicateTest exact(1.0, 0.0, {.delta = 1.0}), measured(1.0, 0.01, {.delta = 1.0});
  for (int i = 0; i < 256; ++i) {
    const double replicate = 1.02 + 0.01 * random.nextNormal();
    exact.add(replicate);
    measured.add(replicate);
  }
  EXPECT_EQ(exact.judge(1).outcome, Outcome::kFail);
  EXPECT_EQ(measured.judge(1).outcome, Outcome::kPass);
  EXPECT_NEAR(measured.judge(1).standardError, std::hypot(0.01, 0.01 / 16.0), 1e-4);
}

TEST(ReplicateTest, TreatsBothSidesAlike) {
  Uniforms random(6);
  ReplicateTest right(1.2, 0.0, {}), left(-1.2, 0.0, {});
  for (int i = 0; i < 256; ++i) {
    const double replicate = -std::log1p(-random.nextDouble());
    right.add(replicate);
    left.add(-replicate);
  }
  EXPECT_NEAR(right.judge(0).pValue, left.judge(0).pValue, 1e-9 * left.judge(0).pValue);
  EXPECT_NEAR(right.judge(0).critical, left.judge(0).critical, 1e-9);
  EXPECT_GT(right.judge(0).skewness, 1.0) << "too low, of what is skew to the right";
}

// One replicate in eight is lit: too skew for t with 64 replicates.
TEST(ReplicateTest, FailsNoVerySkewReplicates) {
  ReplicateTest test(0.9, 0.0, {});
  for (int i = 0; i < 64; ++i) test.add(i % 8 == 0 ? 1.0 : 0.0);
  EXPECT_EQ(test.judge(0).outcome, Outcome::kUndecided);
}

}  // namespace
}  // namespace pathmark::stats
