// How errors fall, and what is remembered of them.
#include "preview/compare/error_curves.h"

#include "support/test_pictures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pathmark::test {
namespace {

using namespace preview;
using testing::Uniforms;

// By least squares, of the logarithms.
double slopeOf(const ErrorCurve& curve, std::optional<double> ErrorPoint::*error) {
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (const ErrorPoint& point : curve.points) {
    const double x = std::log(point.raysPerPixel), y = std::log((point.*error).value());
    n += 1.0, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

double meanSquaredError(const Image& image, double truth) {
  double sum = 0.0;
  for (const float value : image.rgb) {
    const double difference = static_cast<double>(value) - truth;
    sum += difference * difference / (truth * truth + 0.01);
  }
  return sum / static_cast<double>(image.rgb.size());
}

Picture picture(std::uint64_t series, double rays) {
  Picture p = pictureOf(testScene(1, 1), {1, 1, {1, 1, 1}});
  p.series = series;
  p.raysPerPixel = rays;
  return p;
}

ErrorPoint point(double rays, double measured = 0.5) {
  return {.raysPerPixel = rays, .seconds = rays, .measured = measured, .expected = 0.5};
}

// An error that is measured from 3072 values has a relative standard deviation of 2.6 % (the mean
// of squares of normal numbers), so that the slope over a factor of 64 has one of 0.01 at most:
// 0.06 is exceeded with a probability below 1e-8.
TEST(ErrorCurves, OfNoiseHaveASlopeOfMinusOne) {
  Uniforms random(21);
  constexpr double kTruth = 0.7;
  NoisySeries series(testScene(32, 32), 1, random, [](int, int) { return kTruth; });
  const Image reference{32, 32, std::vector<float>(3072, static_cast<float>(kTruth))};
  ErrorCurves curves;
  for (int passes = 4, before = 0; passes <= 256; before = passes, passes *= 2) {
    series.addPasses(passes - before);
    const auto made = series.picture();
    curves.add(*made, 1,
               {.raysPerPixel = made->raysPerPixel,
                .seconds = made->seconds,
                .measured = meanSquaredError(made->image, kTruth),
                .expected = expectedError(made->image, &reference)});
  }
  ASSERT_EQ(curves.current().points.size(), 7u);
  EXPECT_NEAR(slopeOf(curves.current(), &ErrorPoint::measured), -1.0, 0.06);
  EXPECT_NEAR(slopeOf(curves.current(), &ErrorPoint::expected), -1.0, 0.06);
  for (const ErrorPoint& p : curves.current().points)
    EXPECT_NEAR(*p.measured / *p.expected, 1.0, 0.25) << p.raysPerPixel;
}

TEST(ErrorCurves, ALongSeriesHasFourPointsForEachDoublingAndItsNewest) {
  ErrorCurves curves;
  double rays = 1.0;
  for (; rays < 1e6; rays *= 1.003) curves.add(picture(1, rays), 1, point(rays));
  const std::vector<ErrorPoint>& points = curves.current().points;
  EXPECT_LE(points.size(), 4.0 * std::log2(1e6) + 2.0);
  EXPECT_GE(points.size(), 4.0 * std::log2(1e6) - 4.0);
  EXPECT_NEAR(points.back().raysPerPixel, rays / 1.003, 1e-6);
  EXPECT_EQ(points.front().raysPerPixel, 1.0);
  for (std::size_t i = 2; i < points.size(); ++i)
    EXPECT_GE(points[i - 1].raysPerPixel, 1.18 * points[i - 2].raysPerPixel);
}

TEST(ErrorCurves, TheSamePictureAgainIsNoFurtherPoint) {
  ErrorCurves curves;
  for (int k = 0; k < 10; ++k) curves.add(picture(1, 4.0), 1, point(4.0));
  EXPECT_EQ(curves.current().points.size(), 1u);
}

TEST(ErrorCurves, ThreeSeriesBeforeAreRemembered) {
  ErrorCurves curves;
  for (std::uint64_t series = 1; series <= 6; ++series)
    for (const double rays : {1.0, 2.0, 4.0}) curves.add(picture(series, rays), 1, point(rays));
  ASSERT_EQ(curves.before().size(), 3u);
  EXPECT_EQ(curves.before().front().series, 3u);
  EXPECT_EQ(curves.before().back().series, 5u);
  EXPECT_EQ(curves.current().series, 6u);
  EXPECT_EQ(curves.current().name, "student, sobol");
}

TEST(ErrorCurves, AnotherCameraOrSceneForgetsThoseBefore) {
  ErrorCurves curves;
  for (std::uint64_t series = 1; series <= 2; ++series)
    for (const double rays : {1.0, 2.0}) curves.add(picture(series, rays), 1, point(rays));
  ASSERT_EQ(curves.before().size(), 1u);
  Picture moved = picture(3, 1.0);
  moved.camera.eye = {1.0f, 2.0f, 3.0f};
  curves.add(moved, 1, point(1.0));
  EXPECT_TRUE(curves.before().empty());
}

// When another part has been chosen after some pictures of tracePath.
ErrorCurves curvesAtPart(int part) {
  ErrorCurves curves;
  for (const double rays : {1.0, 2.0}) curves.add(picture(1, rays), 1, point(rays));
  Picture other = picture(2, 1.0);
  other.made = pictureOfPart(part);
  curves.add(other, 1, point(1.0));
  return curves;
}

TEST(ErrorCurves, OfPartsThatTraceInAnotherWayStandBesideThoseBefore) {
  const ErrorCurves curves = curvesAtPart(8);
  ASSERT_EQ(curves.before().size(), 1u);
  EXPECT_EQ(curves.before()[0].name, "student, sobol");
  EXPECT_EQ(curves.current().name, "student, sobol, tracePathMIS");
}

TEST(ErrorCurves, TheWarmUpForgetsThoseBefore) { EXPECT_TRUE(curvesAtPart(0).before().empty()); }

TEST(ErrorCurves, AnotherReferenceForgetsWhatWasMeasuredButNotWhatWasExpected) {
  ErrorCurves curves;
  for (std::uint64_t series = 1; series <= 2; ++series)
    for (const double rays : {1.0, 2.0}) curves.add(picture(series, rays), 1, point(rays));
  curves.add(picture(2, 4.0), 2, point(4.0));
  for (const ErrorPoint& p : curves.before()[0].points) {
    EXPECT_FALSE(p.measured);
    EXPECT_TRUE(p.expected);
  }
  EXPECT_FALSE(curves.current().points[0].measured);
  EXPECT_TRUE(curves.current().points.back().measured);
}

TEST(ErrorCurves, WhatIsNoPositiveNumberIsNoPoint) {
  ErrorCurves curves;
  curves.add(picture(1, 1.0), 1, {.raysPerPixel = 1.0, .seconds = 1.0, .measured = 0.0});
  curves.add(picture(1, 2.0), 1, {.raysPerPixel = 2.0, .seconds = 1.0, .measured = NAN});
  curves.add(picture(1, 3.0), 1, {.raysPerPixel = 3.0, .seconds = 1.0, .expected = INFINITY});
  EXPECT_TRUE(curves.current().points.empty());
}

TEST(ExpectedError, IsTheMeanOfRelativeVariancesThatAreKnown) {
  Image image{1, 1, {1.0f, 0.0f, 2.0f}, {}, {0.0101f, 0.001f, INFINITY}};
  EXPECT_NEAR(expectedError(image, nullptr).value(), (0.01 + 0.1) / 2.0, 1e-6);
  const Image reference{1, 1, {0.0f, 0.0f, 0.0f}};
  EXPECT_NEAR(expectedError(image, &reference).value(), (1.01 + 0.1) / 2.0, 1e-6);
  image.variance.clear();
  EXPECT_FALSE(expectedError(image, nullptr));
}

}  // namespace
}  // namespace pathmark::test
