// The false-fail rate of the replicate test as far out as the grader uses it.
#include "stats/replicate_test.h"
#include "tests/support/far_tail.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace pathmark::stats {
namespace {

using testing::BrightReplicate;
using testing::farTail;
using testing::FarTail;

// Standard errors by which a measured rate may exceed the declared one; the seeds are fixed.
constexpr double kSigmas = 3.0;

// Prints the table: false-fail rate over alpha, for replicates of this skewness.
void expectRatesWithinAlpha(double alpha, double skewness, double assumed,
                            std::initializer_list<int> counts) {
  std::printf("alpha %g, skewness %g, assumed %g: rate / alpha\n%14s", alpha, skewness, assumed,
              "bright share");
  for (const int n : counts) std::printf("  n = %-10d", n);
  std::printf("\n");
  for (const double share : {0.3, 0.5, 1.0, 2.0}) {
    std::printf("%14g", share);
    for (const int n : counts) {
      const BrightReplicate replicate = BrightReplicate::withSkewness(skewness, share);
      const FarTail tail = farTail(replicate, n, alpha, assumed, static_cast<std::uint64_t>(n));
      std::printf("  %-6.2g(+-%2.0f%%)", tail.rate / alpha, 100.0 * tail.error / tail.rate);
      EXPECT_LE(tail.rate - kSigmas * tail.error, alpha) << "share " << share << ", n = " << n;
      EXPECT_LT(tail.error, tail.rate) << "the rate was not found";
    }
    std::printf("\n");
  }
}

TEST(FarTail, OfSlightlySkewReplicatesIsWithinTheDeclaredRate) {
  for (const double alpha : {1e-2, 1e-5, 1e-10}) expectRatesWithinAlpha(alpha, 0.5, 0.5, {64, 256});
  expectRatesWithinAlpha(3e-13, 0.5, 0.5, {128, 256});
}

TEST(FarTail, IsWithinTheDeclaredRateUpToOneAndAHalfTimesTheAssumedSkewness) {
  for (const double alpha : {1e-5, 1e-10}) {
    expectRatesWithinAlpha(alpha, 0.75, 0.5, {64, 128, 256});
    expectRatesWithinAlpha(alpha, 1.5, 1.0, {256});
  }
}

// With normal replicates and no assumption of skewness the rate at many replicates is near alpha:
// importance sampling finds the tail that there is.
TEST(FarTail, OfNormalReplicatesIsThatOfStudentsT) {
  const FarTail tail = farTail({}, 256, 1e-10, 0.0, 7);
  std::printf("normal, n = 256: rate / alpha %g +- %g\n", tail.rate / 1e-10, tail.error / 1e-10);
  EXPECT_GT(tail.rate, 0.02 * 1e-10);
  EXPECT_LE(tail.rate - kSigmas * tail.error, 0.5e-10);
}

}  // namespace
}  // namespace pathmark::stats
