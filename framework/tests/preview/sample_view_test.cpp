// How samples are counted, coloured, turned, played and spoken of.
#include "preview/samples/orbit.h"
#include "preview/samples/playback.h"
#include "preview/samples/sample_colouring.h"
#include "preview/samples/sample_histogram.h"
#include "preview/samples/sample_verdict.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pathmark::preview::test {
namespace {

using F = CourseworkFunction;

Marginal unitInterval() {
  return {"x", 0.0, 1.0, [](const glm::dvec3& p) { return p.x; },
          [](double from, double to) { return to - from; }};
}

TEST(SampleHistogram, BarsAreSharesOfAllSamples) {
  const std::vector<WeightedPlace> places{{{0.1, 0, 0}}, {{0.3, 0, 0}}, {{0.9, 0, 0}}};
  const Histogram histogram = makeHistogram(unitInterval(), places, 4, 2, false);
  ASSERT_EQ(histogram.bars.size(), 2u);
  EXPECT_DOUBLE_EQ(histogram.bars[0].share, 0.5);
  EXPECT_DOUBLE_EQ(histogram.bars[1].share, 0.25);
  EXPECT_DOUBLE_EQ(histogram.bars[0].expected, 0.5);
  EXPECT_DOUBLE_EQ(histogram.bars[0].sigma, 0.25);  // sqrt(1/2 (1 - 1/2) / 4)
}

TEST(SampleHistogram, WeightsCountAndWidenTheBand) {
  const std::vector<WeightedPlace> places{{{0.1, 0, 0}, 3.0}, {{0.9, 0, 0}, 0.5}};
  const Histogram histogram = makeHistogram(unitInterval(), places, 2, 2, true);
  EXPECT_DOUBLE_EQ(histogram.bars[0].share, 1.5);
  EXPECT_DOUBLE_EQ(histogram.bars[0].sigma, std::sqrt(0.5 * 3.0 / 2.0));
  EXPECT_DOUBLE_EQ(histogram.bars[1].sigma, std::sqrt(0.5 * 0.5 / 2.0));
}

TEST(SampleHistogram, AnEndOfTheAxisBelongsToIt) {
  const std::vector<WeightedPlace> places{{{0.0, 0, 0}}, {{1.0, 0, 0}}, {{1.5, 0, 0}}};
  const Histogram histogram = makeHistogram(unitInterval(), places, 3, 4, false);
  EXPECT_DOUBLE_EQ(histogram.bars.front().share, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(histogram.bars.back().share, 1.0 / 3.0);
}

std::vector<Tally> counts(const std::vector<int>& each) {
  std::vector<Tally> tallies;
  for (const int k : each) tallies.push_back({static_cast<double>(k), static_cast<double>(k)});
  return tallies;
}

// Counts 30, 20, 30, 20 of 100 where 25 are expected: chi-square 4 with 3 degrees of freedom.
TEST(CellTest, IsPearsonsForCounts) {
  const std::vector<double> masses(4, 0.25);
  const CellTest test = testCells(masses, counts({30, 20, 30, 20}), 100, 0, false);
  EXPECT_TRUE(test.possible);
  EXPECT_EQ(test.cells, 4u);
  EXPECT_NEAR(test.pValue, 0.26146, 1e-5);
}

TEST(CellTest, SamplesElsewhereAreImpossible) {
  const std::vector<double> masses(4, 0.25);
  EXPECT_EQ(testCells(masses, counts({25, 25, 25, 24}), 100, 1, false).pValue, 0.0);
}

TEST(CellTest, FewSamplesInManyCellsArePutTogether) {
  const std::vector<double> masses(100, 0.01);
  std::vector<int> all(100, 0);
  for (int k = 0; k < 64; ++k) all[static_cast<std::size_t>(k)] = 1;
  const CellTest test = testCells(masses, counts(all), 64, 0, false);
  EXPECT_TRUE(test.possible);
  EXPECT_LE(test.cells, 8u);
  EXPECT_FALSE(testCells(masses, counts(std::vector<int>(100, 0)), 7, 0, false).possible);
}

TEST(Orbit, TheMiddleStaysInTheMiddleWhicheverWayItIsTurned) {
  Sketch sketch;
  sketch.centre = {1, 2, 3};
  Orbit orbit(sketch);
  orbit.drag({0.3, -0.2});
  orbit.zoom(2.0);
  EXPECT_NEAR(glm::length(orbit.project(sketch.centre)), 0.0, 1e-12);
}

TEST(Orbit, LooksStraightAtWhatIsFlat) {
  Sketch sketch;
  sketch.flat = true;
  const Orbit orbit(sketch);
  const glm::dvec3 right = orbit.project({0.5, 0, 0}), above = orbit.project({0, 0.5, 0});
  EXPECT_NEAR(right.x, 0.5, 1e-12);
  EXPECT_NEAR(right.y, 0.0, 1e-12);
  EXPECT_NEAR(above.y, 0.5, 1e-12);
}

TEST(Orbit, WhatIsNearerIsLargerAndHasTheGreaterDepth) {
  Sketch sketch;
  sketch.flat = true;
  const Orbit orbit(sketch);
  const glm::dvec3 near = orbit.project({0.5, 0, 0.5}), far = orbit.project({0.5, 0, -0.5});
  EXPECT_GT(near.x, far.x);
  EXPECT_GT(near.z, far.z);
}

TEST(Orbit, ADragToTheRightTakesTheFrontAlong) {
  Sketch sketch;
  sketch.flat = true;
  Orbit orbit(sketch);
  orbit.drag({0.1, 0.0});
  EXPECT_GT(orbit.project({0, 0, 0.5}).x, 0.0);
  orbit.drag({-0.1, 0.1});
  EXPECT_LT(orbit.project({0, 0, 0.5}).y, 0.0);
}

TEST(Orbit, NeverTurnsOverTheTop) {
  Orbit orbit(Sketch{});
  for (int k = 0; k < 50; ++k) orbit.drag({0.0, 0.2});
  EXPECT_GT(orbit.project({0, 0.5, 0}).y, 0.0);
}

TEST(Orbit, GoesOnFromTheSameSideWhenTheSketchMoves) {
  Sketch sketch;
  Orbit orbit(sketch);
  orbit.drag({0.2, 0.1});
  const glm::dvec3 before = orbit.project({0.3, 0.2, 0.1});
  sketch.centre = {5, 0, 0};
  orbit.lookAt(sketch);
  EXPECT_NEAR(glm::length(orbit.project({5.3, 0.2, 0.1}) - before), 0.0, 1e-12);
}

TEST(Playback, ShowsAllUnlessItPlays) {
  Playback playback;
  EXPECT_EQ(playback.shown(512, 3.0), 512u);
}

TEST(Playback, ShowsOneAfterAnotherAndEndsWithAll) {
  Playback playback;
  playback.start(10.0);
  EXPECT_EQ(playback.shown(512, 10.0), 1u);
  const std::size_t later = playback.shown(512, 14.0);
  EXPECT_GT(later, 100u);
  EXPECT_LT(later, 400u);
  EXPECT_EQ(playback.shown(512, 60.0), 512u);
  EXPECT_FALSE(playback.playing());
}

SampleSet threeSamples(F function) {
  SampleSet set;
  set.settings.function = function;
  set.claims = true;
  set.claimed = Range{1.0, 3.0};
  for (int k = 0; k < 3; ++k) {
    Sample sample;
    sample.numbers = {0.25f * static_cast<float>(k), 0.5f, 0.75f};
    sample.claimed = 1.0 + k;
    set.samples.push_back(sample);
  }
  return set;
}

TEST(Colouring, RunsFromTheFirstToTheLast) {
  const SampleSet set = threeSamples(F::kLambertianReflection);
  EXPECT_EQ(sampleColours(Colouring::kOrder, set).places, (std::vector<float>{0.0f, 0.5f, 1.0f}));
  EXPECT_EQ(sampleColours(Colouring::kClaimed, set).places, (std::vector<float>{0.0f, 0.5f, 1.0f}));
  EXPECT_EQ(sampleColours(Colouring::kFirstNumber, set).places,
            (std::vector<float>{0.0f, 0.25f, 0.5f}));
}

TEST(Colouring, OffersOnlyWhatThereIs) {
  SampleSet set = threeSamples(F::kGetRandomNumbers);
  set.claims = false;
  EXPECT_TRUE(canShow(Colouring::kOrder, set));
  EXPECT_FALSE(canShow(Colouring::kFirstNumber, set));
  EXPECT_FALSE(canShow(Colouring::kClaimed, set));
  EXPECT_TRUE(canShow(Colouring::kThirdNumber, threeSamples(F::kPhongReflection)));
}

constexpr std::uint64_t kBuild = 4;

CheckReport reportOf(Outcome outcome) {
  CheckReport report;
  report.build = kBuild;
  report.finished = true;
  FunctionVerdict verdict;
  verdict.function = F::kSampleSphere;
  verdict.outcome = outcome;
  verdict.build = kBuild;
  verdict.checks.resize(2);
  verdict.checks[0].outcome = Outcome::kPass;
  verdict.checks[1] = {"0.4/uniform",
                       "directions are uniform",
                       outcome,
                       {},
                       {},
                       {},
                       {{"cause", "theta is uniform"}}};
  report.functions = {verdict};
  return report;
}

CourseworkState courseworkOf(std::uint64_t number) {
  CourseworkState state;
  state.number = number;
  return state;
}

VerdictWords wordsFor(const CheckReport& report, std::uint64_t number = kBuild) {
  return verdictOn(F::kSampleSphere, courseworkOf(number), &report);
}

TEST(SampleVerdict, SaysWhichCheckFailsAndWhatItFound) {
  const VerdictWords words = wordsFor(reportOf(Outcome::kFail));
  EXPECT_EQ(words.outcome, Outcome::kFail);
  EXPECT_EQ(words.headline, "Wrong, by 0.4/uniform: directions are uniform.");
  ASSERT_EQ(words.found.size(), 1u);
  EXPECT_EQ(words.found[0].value, "theta is uniform");
}

TEST(SampleVerdict, IsThatOfTheChecks) {
  for (const Outcome outcome : {Outcome::kPass, Outcome::kFail, Outcome::kUndecided,
                                Outcome::kBroken, Outcome::kNotWritten, Outcome::kBlocked})
    EXPECT_EQ(wordsFor(reportOf(outcome)).outcome, outcome);
  EXPECT_EQ(wordsFor(reportOf(Outcome::kPass)).headline, "Right, by 2 checks.");
}

TEST(SampleVerdict, IsNotThatOfAnEarlierSave) {
  EXPECT_EQ(wordsFor(reportOf(Outcome::kPass), kBuild + 1).outcome, Outcome::kUnknown);
  EXPECT_EQ(verdictOn(F::kSampleSphere, courseworkOf(kBuild), nullptr).outcome, Outcome::kUnknown);
}

TEST(SampleVerdict, KnowsAnUnwrittenFunctionBeforeTheChecksDo) {
  CourseworkState state = courseworkOf(kBuild);
  state.stubs.unwritten.push_back(contractOf(F::kSampleSphere));
  EXPECT_EQ(verdictOn(F::kSampleSphere, state, nullptr).headline, "Not written yet.");
}

}  // namespace
}  // namespace pathmark::preview::test
