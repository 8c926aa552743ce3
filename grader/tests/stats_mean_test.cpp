// The tests of means, tested: they fail a true mean as often as they declare, and find a wrong
// one.
#include "stats/mean_test.h"
#include "stats/pooled_variance.h"
#include "stats/quantiles.h"
#include "tests/support/uniforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pathmark::stats {
namespace {

using testing::Uniforms;

// The measured rates below are themselves binomial; with fixed seeds they are constants, and the
// bounds are five standard deviations of what other seeds would give.
constexpr int kRuns = 20000;
constexpr double kSigmas = 5.0;

template <typename Run>
double measuredRate(int runs, Run&& fails) {
  int failures = 0;
  for (int run = 0; run < runs; ++run) failures += fails() ? 1 : 0;
  return static_cast<double>(failures) / runs;
}

double rateError(double rate, int runs) { return kSigmas * std::sqrt(rate * (1 - rate) / runs); }

TEST(RunningMoments, EqualTheTwoPassFormulas) {
  Uniforms random(1);
  std::vector<double> numbers;
  RunningMoments moments;
  for (int i = 0; i < 1000; ++i) {
    numbers.push_back(1e6 + std::exp(random.nextNormal()));
    moments.add(numbers.back());
  }
  double mean = 0.0, m2 = 0.0, m3 = 0.0;
  for (const double x : numbers) mean += x / 1000.0;
  for (const double x : numbers) m2 += (x - mean) * (x - mean);
  for (const double x : numbers) m3 += (x - mean) * (x - mean) * (x - mean);
  EXPECT_EQ(moments.count(), 1000);
  EXPECT_NEAR(moments.mean(), mean, 1e-8);
  EXPECT_NEAR(moments.variance(), m2 / 999.0, 1e-7 * m2 / 999.0);
  EXPECT_NEAR(moments.skewness(), std::sqrt(1000.0) * m3 / std::pow(m2, 1.5), 1e-6);
}

TEST(RunningMoments, OfTwoMergedStreamsEqualThoseOfOne) {
  Uniforms random(2);
  RunningMoments all, first, second, empty;
  for (int i = 0; i < 500; ++i) {
    const double x = random.nextDouble() * random.nextDouble();
    all.add(x);
    (i < 123 ? first : second).add(x);
  }
  first.merge(second);
  first.merge(empty);
  empty.merge(first);
  EXPECT_NEAR(empty.mean(), all.mean(), 1e-14);
  EXPECT_NEAR(empty.variance(), all.variance(), 1e-14);
  EXPECT_NEAR(empty.skewness(), all.skewness(), 1e-11);
}

TEST(RunningMoments, OfEqualNumbersHaveNoVariance) {
  RunningMoments moments;
  for (int i = 0; i < 1000; ++i) moments.add(0.1);
  EXPECT_EQ(moments.variance(), 0.0);
  EXPECT_EQ(moments.skewness(), 0.0);
}

TEST(TestMean, FailsATrueMeanAtTheDeclaredRate) {
  Uniforms random(3);
  for (const double alpha : {0.1, 0.01, 0.001}) {
    for (const int n : {5, 64}) {
      const double rate = measuredRate(kRuns, [&] {
        RunningMoments samples;
        for (int i = 0; i < n; ++i) samples.add(3.0 + 2.0 * random.nextNormal());
        return !testMean(samples, 3.0, {.alpha = alpha}).pass;
      });
      EXPECT_NEAR(rate, alpha, rateError(alpha, kRuns)) << "n = " << n;
    }
  }
}

// Exponential: skewness 2, here 0.05 sqrt(n).
TEST(TestMean, FailsATrueMeanOfSkewedSamplesAtTheDeclaredRate) {
  Uniforms random(7);
  constexpr int kSkewedRuns = 10000;
  for (const double alpha : {0.01, 0.001}) {
    const double rate = measuredRate(kSkewedRuns, [&] {
      RunningMoments samples;
      for (int i = 0; i < 1600; ++i) samples.add(-std::log1p(-random.nextDouble()));
      return !testMean(samples, 1.0, {.alpha = alpha}).pass;
    });
    EXPECT_NEAR(rate, alpha, rateError(alpha, kSkewedRuns) + 0.3 * alpha);
  }
}

TEST(TestMean, FindsAnErrorOfOnePercentWithTheStatedPower) {
  Uniforms random(4);
  constexpr int kSamples = 4000;
  constexpr MeanTest kSettings{.alpha = 1e-7};
  constexpr double kPower = 0.9;
  RunningMoments typical;
  for (int i = 0; i < kSamples; ++i) typical.add(random.nextDouble());
  const double error = smallestError(typical, kSettings, kPower);
  constexpr int kPowerRuns = 1000;
  const double found = measuredRate(kPowerRuns, [&] {
    RunningMoments samples;
    for (int i = 0; i < kSamples; ++i) samples.add(random.nextDouble());
    return !testMean(samples, 0.5 + error, kSettings).pass;
  });
  EXPECT_NEAR(found, kPower, rateError(kPower, kPowerRuns) + 0.02);

  RunningMoments many;
  for (int i = 0; i < 400000; ++i) many.add(random.nextDouble());
  EXPECT_TRUE(testMean(many, 0.5, kSettings).pass);
  EXPECT_FALSE(testMean(many, 0.505, kSettings).pass);
}

TEST(TestMean, AcceptsErrorsWithinTheTolerance) {
  RunningMoments samples;
  for (int i = 0; i < 100; ++i) samples.add(1.0);
  EXPECT_TRUE(testMean(samples, 1.0, {}).pass);
  EXPECT_FALSE(testMean(samples, 1.0 + 1e-9, {}).pass);
  EXPECT_TRUE(testMean(samples, 1.0 + 1e-9, {.tolerance = 1e-8}).pass);
  EXPECT_TRUE(testMean(samples, 1.0 + 1e-9, {.deviationFloor = 1e-8}).pass);
  EXPECT_FALSE(testMean(samples, 1.1, {.tolerance = 1e-8, .deviationFloor = 1e-8}).pass);
}

TEST(TestMean, FailsWhatIsNotFiniteAndWhatIsTooLittle) {
  RunningMoments one, infinite, nan;
  one.add(1.0);
  EXPECT_FALSE(testMean(one, 1.0, {}).pass);
  for (int i = 0; i < 10; ++i) infinite.add(std::numeric_limits<double>::infinity());
  for (int i = 0; i < 10; ++i) nan.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(testMean(infinite, 1.0, {}).pass);
  EXPECT_FALSE(testMean(nan, 1.0, {}).pass);
  EXPECT_FALSE(testMeans(nan, infinite, {}).pass);
}

TEST(TestMeans, FailEqualMeansOfUnequalVarianceAtTheDeclaredRate) {
  Uniforms random(5);
  constexpr double kAlpha = 0.01;
  const double rate = measuredRate(kRuns, [&] {
    RunningMoments a, b;
    for (int i = 0; i < 10; ++i) a.add(random.nextNormal());
    for (int i = 0; i < 40; ++i) b.add(7.0 * random.nextNormal());
    return !testMeans(a, b, {.alpha = kAlpha}).pass;
  });
  EXPECT_NEAR(rate, kAlpha, rateError(kAlpha, kRuns));
}

TEST(TestMeans, TellMeansApartThatDifferByOnePercent) {
  Uniforms random(6);
  RunningMoments a, b;
  for (int i = 0; i < 400000; ++i) a.add(random.nextDouble());
  for (int i = 0; i < 400000; ++i) b.add(1.01 * random.nextDouble());
  EXPECT_FALSE(testMeans(a, b, {.alpha = 1e-7}).pass);
}

TEST(TestMeans, OfEstimatesEqualThoseOfTheSamples) {
  Uniforms random(8);
  RunningMoments a, b;
  for (int i = 0; i < 20; ++i) a.add(random.nextNormal());
  for (int i = 0; i < 50; ++i) b.add(1.0 + 3.0 * random.nextNormal());
  const Verdict samples = testMeans(a, b, {});
  const Verdict estimates = testMeans({a.mean(), a.variance() / 20.0, 19.0},
                                      {b.mean(), b.variance() / 50.0, 49.0}, MeanTest{});
  EXPECT_NEAR(estimates.statistic, samples.statistic, 1e-12);
  EXPECT_NEAR(estimates.degrees, samples.degrees, 1e-9);
  EXPECT_NEAR(estimates.critical, samples.critical, 1e-9);
}

// A region of 64 pixels, each with the variance of 8 replicates, against a known mean.
TEST(TestMeans, OfPooledPixelsFailAtTheDeclaredRate) {
  Uniforms random(9);
  constexpr double kAlpha = 0.01;
  constexpr int kPixels = 64, kReplicates = 8;
  const double rate = measuredRate(kRuns, [&] {
    PooledVariance pooled;
    double sum = 0.0;
    for (int pixel = 0; pixel < kPixels; ++pixel) {
      RunningMoments replicates;
      for (int i = 0; i < kReplicates; ++i) replicates.add((1 + pixel % 4) * random.nextNormal());
      sum += replicates.mean();
      pooled.add(replicates.variance() / kReplicates, kReplicates - 1.0);
    }
    const MeanEstimate region{sum, pooled.variance(), pooled.degrees()};
    return !testMeans(region, MeanEstimate{}, {.alpha = kAlpha}).pass;
  });
  EXPECT_NEAR(rate, kAlpha, rateError(kAlpha, kRuns) + 0.1 * kAlpha);
}

TEST(TestMeans, OfEstimatesWithoutSenseFail) {
  const MeanEstimate good{1.0, 0.1, 9.0}, infinite{1.0, HUGE_VAL, 9.0}, negative{1.0, -1.0, 9.0};
  EXPECT_TRUE(testMeans(good, good, MeanTest{}).pass);
  EXPECT_FALSE(testMeans(good, infinite, MeanTest{}).pass);
  EXPECT_FALSE(testMeans(negative, good, MeanTest{}).pass);
  EXPECT_FALSE(testMeans(good, MeanEstimate{1.0, 0.1, 0.0}, MeanTest{}).pass);
  EXPECT_TRUE(testMeans(MeanEstimate{1.0}, MeanEstimate{1.0}, MeanTest{}).pass);
  EXPECT_FALSE(testMeans(MeanEstimate{1.0}, MeanEstimate{1.1}, MeanTest{}).pass);
  EXPECT_TRUE(testMeans(MeanEstimate{1.0}, MeanEstimate{1.1}, {.deviationFloor = 0.1}).pass);
}

TEST(Quantiles, EqualTabulatedValues) {
  EXPECT_NEAR(studentCritical(0.05, 10), 2.228138852, 1e-8);
  EXPECT_NEAR(studentCritical(1e-10, 15), 15.7, 0.1);
  EXPECT_NEAR(chiSquareCritical(0.05, 7), 14.06714045, 1e-7);
  EXPECT_NEAR(studentTail(2.228138852, 10), 0.05, 1e-9);
  EXPECT_NEAR(chiSquareTail(14.06714045, 7), 0.05, 1e-9);
  EXPECT_GT(chiSquareTail(400, 50), 0.0) << "far tails do not cancel to zero";
}

TEST(SampleQuantile, InterpolatesBetweenOrderStatistics) {
  const std::vector<double> numbers{1.0, 2.0, 4.0, 8.0};
  EXPECT_EQ(sampleQuantile(numbers, 0.0), 1.0);
  EXPECT_EQ(sampleQuantile(numbers, 0.5), 3.0);
  EXPECT_EQ(sampleQuantile(numbers, 1.0), 8.0);
  EXPECT_EQ(sampleQuantile(std::vector<double>{5.0}, 0.3), 5.0);
}

}  // namespace
}  // namespace pathmark::stats
