// The sRGB curve, and its table of bytes.
#include "film/srgb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pathmark::test {
namespace {

TEST(Srgb, DecodingUndoesEncoding) {
  for (int i = 0; i <= 1000; ++i) {
    const double linear = i / 1000.0;
    EXPECT_NEAR(decodeSrgb(encodeSrgb(linear)), linear, 1e-7);
  }
}

TEST(Srgb, BytesAreTheCurveRounded) {
  const SrgbBytes& bytes = SrgbBytes::table();
  for (int i = 0; i <= 1000000; ++i) {
    const double linear = i / 1000000.0;
    ASSERT_EQ(bytes(linear), std::lround(255.0 * encodeSrgb(linear))) << linear;
  }
}

TEST(Srgb, EveryByteBeginsHalfAStepBelowIt) {
  const SrgbBytes& bytes = SrgbBytes::table();
  for (int value = 1; value < 256; ++value) {
    const double from = decodeSrgb((value - 0.5) / 255.0);
    EXPECT_EQ(bytes(from * (1.0 - 1e-12)), value - 1);
    EXPECT_EQ(bytes(from * (1.0 + 1e-12)), value);
  }
}

TEST(Srgb, WhatIsNoLinearValueIsClipped) {
  const SrgbBytes& bytes = SrgbBytes::table();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(bytes(-1e-3), 0);
  EXPECT_EQ(bytes(-kInfinity), 0);
  EXPECT_EQ(bytes(1.0), 255);
  EXPECT_EQ(bytes(1e300), 255);
  EXPECT_EQ(bytes(kInfinity), 255);
  EXPECT_EQ(bytes(std::numeric_limits<double>::quiet_NaN()), 0);
}

}  // namespace
}  // namespace pathmark::test
