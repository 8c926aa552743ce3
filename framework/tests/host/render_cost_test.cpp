// What bench cost concludes from times: made-up ones, as a test of real ones would fail on a busy
// machine.
#include "bench/render_cost.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pathmark::bench {
namespace {

// Five runs each of 1, 4 and 16, a little apart from each other.
CostSweep growing(double power) {
  CostSweep sweep;
  for (const double amount : {1.0, 4.0, 16.0}) {
    CostPoint point{amount, 1000.0 * amount, {}, {}};
    for (const double off : {-0.02, -0.01, 0.0, 0.01, 0.02})
      point.cpuSeconds.push_back(0.025 * std::pow(amount, power) * (1.0 + off));
    sweep.points.push_back(std::move(point));
  }
  return sweep;
}

TEST(RenderCost, GrowsWithThePowerOfTheTimes) {
  for (const double power : {0.5, 1.0, 2.0}) {
    const Interval found = costSlope(growing(power));
    EXPECT_NEAR(found.value, power, 1e-12);
    EXPECT_LE(found.low, found.value);
    EXPECT_GE(found.high, found.value);
  }
}

// A picture of 1,000 pixels: 25 us for each of its rays, however many of them a pixel has.
TEST(RenderCost, OfARayIsThatOfThePictureOverAllOfItsCameraRays) {
  for (const CostPoint& point : growing(1.0).points)
    EXPECT_NEAR(microsecondsPerRay(point), 25.0, 1e-9) << point.amount;
}

TEST(RenderCost, HasAnIntervalAsWideAsTheRunsAreApart) {
  CostSweep sweep = growing(1.0);
  sweep.points[2].cpuSeconds = {0.2, 0.3, 0.4, 0.5, 0.6};
  const Interval found = costSlope(sweep);
  EXPECT_GT(found.high - found.low, 0.2);
  EXPECT_LT(found.low, 1.0);
  EXPECT_GT(found.high, 1.0);
}

TEST(RenderCost, LeavesOutWhatTookNoLongerThanTheStart) {
  CostSweep sweep = growing(1.0);
  sweep.points[0].cpuSeconds = {-0.001, 0.0, 0.0, 0.0, 0.0};
  EXPECT_NEAR(costSlope(sweep).value, 1.0, 1e-12);
}

TEST(RenderCost, OfOnePointHasNoPower) {
  CostSweep sweep = growing(1.0);
  sweep.points.resize(1);
  EXPECT_TRUE(std::isnan(costSlope(sweep).low));
}

}  // namespace
}  // namespace pathmark::bench
