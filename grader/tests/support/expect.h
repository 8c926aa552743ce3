// Assertions in the words of the coursework's contracts.
//
//   meanIs, meansAgree, cellsAre   statistical, with a declared false-fail rate
//   isUnit, isClose, isFinite
//
// There are fewer than 5000 statistical comparisons in all tests together. At the rate of 1e-7
// that every one declares, a correct solution would fail any of them for at most five seeds in
// ten thousand; the seeds are fixed.
#pragma once

#include "stats/mean_test.h"
#include "stats/weighted_cells.h"

#include <pathmark/types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <span>

namespace pathmark::testing {

// False-fail rate of each statistical comparison.
inline constexpr double kAlpha = 1e-7;

inline constexpr double kPiD = std::numbers::pi;
inline constexpr double kRoundoff = 0x1p-24;  // half the distance between floats next to 1

inline ::testing::AssertionResult meanIs(const stats::RunningMoments& samples, double expected,
                                         const stats::MeanTest& settings) {
  const stats::Verdict verdict = stats::testMean(samples, expected, settings);
  if (verdict) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << "the mean should be " << expected << " and is " << samples.mean() << " +- "
         << samples.standardError() << " after " << samples.count() << " samples; "
         << verdict.statistic << " standard errors off, allowed are " << verdict.critical;
}

inline ::testing::AssertionResult meansAgree(const stats::RunningMoments& actual,
                                             const stats::RunningMoments& expected,
                                             const stats::MeanTest& settings) {
  const stats::Verdict verdict = stats::testMeans(actual, expected, settings);
  if (verdict) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << "the mean should be " << expected.mean() << " +- " << expected.standardError()
         << " and is " << actual.mean() << " +- " << actual.standardError() << "; "
         << verdict.statistic << " standard errors apart, allowed are " << verdict.critical;
}

inline ::testing::AssertionResult cellsAre(const stats::WeightedCells& cells,
                                           std::span<const double> probabilities, double alpha) {
  const stats::Verdict verdict = cells.test(probabilities, alpha);
  if (verdict) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << "chi-square is " << verdict.statistic << " with " << verdict.degrees
         << " degrees of freedom, allowed is " << verdict.critical;
}

inline bool isFinite(const Vector& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// A correctly rounded unit vector is off by at most 0.87 roundoffs, and one that was normalised
// in float by about three.
inline constexpr double kUnitRoundoffs = 4.0;

inline ::testing::AssertionResult isUnit(const Vector& v, double roundoffs = kUnitRoundoffs) {
  const double error = glm::length(glm::dvec3(v)) - 1.0;
  if (std::abs(error) <= roundoffs * 0x1p-24) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "(" << v.x << ", " << v.y << ", " << v.z
                                       << ") is not a unit vector: length - 1 = " << error;
}

inline ::testing::AssertionResult isClose(double actual, long double expected, double relative,
                                          double absolute = 0.0) {
  const double error = static_cast<double>(std::abs(actual - expected));
  const double allowed = relative * static_cast<double>(std::abs(expected)) + absolute;
  if (error <= allowed) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << "should be " << static_cast<double>(expected) << " and is " << actual
         << ": relative error " << error / static_cast<double>(std::abs(expected))
         << ", absolute error " << error << ", allowed are " << relative << " and " << absolute;
}

}  // namespace pathmark::testing
