// Logarithmic axes and their ticks.
#include "preview/compare/log_axis.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pathmark::test {
namespace {

using namespace preview;

std::vector<std::string> labels(const LogAxis& axis, int most) {
  std::vector<std::string> labels;
  for (const LogTick& tick : axis.ticks(most))
    if (!tick.label.empty()) labels.push_back(tick.label);
  return labels;
}

TEST(LogAxis, EveryNumberIsOnIt) {
  const std::vector<double> values{3e-7, 0.02, 1.0, 5e4};
  const LogAxis axis = axisFor(values);
  for (const double value : values) {
    EXPECT_GE(axis.place(value), 0.0);
    EXPECT_LE(axis.place(value), 1.0);
  }
  EXPECT_DOUBLE_EQ(axis.place(axis.low), 0.0);
  EXPECT_DOUBLE_EQ(axis.place(axis.high), 1.0);
}

TEST(LogAxis, EqualRatiosAreEquallyLong) {
  const LogAxis axis{0.1, 1000.0};
  EXPECT_NEAR(axis.place(1.0) - axis.place(0.1), 0.25, 1e-12);
  EXPECT_NEAR(axis.place(1000.0) - axis.place(100.0), 0.25, 1e-12);
}

TEST(LogAxis, OneNumberOrNoneStillMakesAnAxis) {
  EXPECT_GT(axisFor({}).high, axisFor({}).low);
  const LogAxis axis = axisFor({5.0, 5.0});
  EXPECT_NEAR(axis.place(5.0), 0.5, 1e-12);
  EXPECT_GE(axis.high / axis.low, 10.0);
}

TEST(LogAxis, TicksAreLabelledAtPowersOfTen) {
  EXPECT_EQ(labels({0.01, 100.0}, 5), (std::vector<std::string>{"0.01", "0.1", "1", "10", "100"}));
  EXPECT_EQ(labels({1.5, 30.0}, 6), (std::vector<std::string>{"2", "5", "10", "20"}));
}

TEST(LogAxis, LongAxesHaveNoMoreLabelsThanThereIsRoomFor) {
  for (const double high : {1e3, 1e6, 1e12, 1e30, 1e100}) {
    const LogAxis axis{1e-6, high};
    EXPECT_GE(labels(axis, 5).size(), 2u) << high;
    EXPECT_LE(labels(axis, 5).size(), 7u) << high;
    EXPECT_LE(axis.ticks(5).size(), 100u) << high;
  }
}

TEST(LogAxis, TicksAreOnTheAxis) {
  const LogAxis axis{0.017, 43.0};
  for (const LogTick& tick : axis.ticks(6)) {
    EXPECT_GE(axis.place(tick.value), 0.0);
    EXPECT_LE(axis.place(tick.value), 1.0);
  }
}

TEST(LogAxis, LabelsAreShort) {
  EXPECT_EQ(logLabel(1e-6), "1e-6");
  EXPECT_EQ(logLabel(2e-5), "2e-5");
  EXPECT_EQ(logLabel(0.001), "0.001");
  EXPECT_EQ(logLabel(0.05), "0.05");
  EXPECT_EQ(logLabel(1.0), "1");
  EXPECT_EQ(logLabel(2000.0), "2000");
  EXPECT_EQ(logLabel(1e5), "1e5");
}

}  // namespace
}  // namespace pathmark::test
