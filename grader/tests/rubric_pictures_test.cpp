// Marks for what mistakes do to pictures.
#include "support/made_record.h"

#include <algorithm>
#include <cmath>

namespace pathmark::rubric {
namespace {

TEST_F(Marking, ABandReachesToItsBound) {
  useSimpleRubric();
  fail(function(record_, "3.1"));
  rubric_.wrongAtMost = 1.0;
  const auto creditOf = [&](double low) {
    part(record_, 3).pictures = {picture("a room", {low + 0.01, low, low + 0.02})};
    return lineOf(mark(), "3.1").points / 4.0;
  };
  for (std::size_t i = 0; i < rubric_.biasBands.size(); ++i) {
    const BiasBand& band = rubric_.biasBands[i];
    const double next = i + 1 < rubric_.biasBands.size() ? rubric_.biasBands[i + 1].credit : 0.0;
    EXPECT_DOUBLE_EQ(creditOf(band.biasAtMost), band.credit);
    EXPECT_DOUBLE_EQ(creditOf(std::nextafter(band.biasAtMost, 1e9)), next);
  }
  EXPECT_DOUBLE_EQ(creditOf(0.0), 1.0);
  rubric_.wrongAtMost = 0.7;
  EXPECT_DOUBLE_EQ(creditOf(0.0), 0.7);
}

TEST_F(Marking, ALargerBiasNeverEarnsMore) {
  for (const std::string section : {"2.4", "3.1", "5.1"}) {
    record_ = rightRecord();
    fail(function(record_, section));
    PartRecord& p = part(record_, section[0] - '0');
    double before = 1e9;
    for (int i = 0; i <= 1000; ++i) {
      const double bias = 0.001 * i;
      p.pictures = {picture("a", {0.01, 0.005, 0.02}), picture("b", {bias, 0.9 * bias, 2 * bias})};
      record_.pictures = p.pictures;
      const double points = mark().points;
      EXPECT_LE(points, before) << bias;
      before = points;
    }
    EXPECT_LT(before, 100.0);
  }
}

TEST_F(Marking, TheWorstPictureCounts) {
  useSimpleRubric();
  fail(function(record_, "3.1"));
  part(record_, 3).pictures = {picture("dim", {0.01, 0.005, 0.02}),
                               picture("bright", {0.4, 0.3, 0.5}),
                               picture("far", {0.1, 0.05, 0.9})};
  expectReason(mark(), "3.1",
               "Wrong in 3.1/valid. The picture of bright is 40 % (30 % to 50 %) off.");
  part(record_, 3).pictures[0].failure = "it crashed";
  EXPECT_EQ(lineOf(mark(), "3.1").points, 0.0);
}

// Where none is surely off, the one that is off most by its value.
TEST_F(Marking, TheReasonNamesThePictureThatIsOffMost) {
  useSimpleRubric();
  part(record_, 3).pictures = {picture("a", {0.0, 0.0, 0.04}), picture("b", {0.01, 0.0, 0.02})};
  fail(function(record_, "3.1"));
  expectReason(mark(), "3.1", "The picture of b is 1 %");
}

TEST_F(Marking, WithoutAPictureAMistakeEarnsAFixedShare) {
  useSimpleRubric();
  part(record_, 3).pictures.clear();
  fail(function(record_, "3.1"));
  EXPECT_DOUBLE_EQ(lineOf(mark(), "3.1").points, 4.0 * rubric_.withoutPicture);
}

TEST_F(Marking, WhatIsBlockedAndNotSeenEarnsNothingAndNamesTheBlocker) {
  useSimpleRubric();
  part(record_, 3).pictures.clear();
  FunctionRecord& f = function(record_, "3.3");
  fail(f, "samples", Verdict::kBlocked);
  f.checks.back().cause = "lambertianBRDF::pdf must be right first";
  EXPECT_EQ(lineOf(mark(), "3.3").points, 0.0);
  expectReason(mark(), "3.3", "lambertianBRDF::pdf must be right first");
}

TEST_F(Marking, EfficiencyEarnsTheHighestBandThatItsIntervalReaches) {
  useSimpleRubric();
  rubric_.parts[0].efficiency = 4.0;
  const auto pointsOf = [&](double value, double low, double high) {
    part(record_, 3).pictures[0].efficiency = record::Estimate{value, low, high};
    return lineOf(mark(), "efficiency").points;
  };
  EXPECT_DOUBLE_EQ(pointsOf(0.7, 0.6, 0.8), 4.0);
  EXPECT_DOUBLE_EQ(pointsOf(0.7, 0.6, 0.799), 3.0);
  EXPECT_DOUBLE_EQ(pointsOf(0.2, 0.15, 0.249), 1.0);
  EXPECT_DOUBLE_EQ(pointsOf(0.05, 0.01, 0.09), 0.0);
  expectReason(
      mark(), "efficiency",
      "In a room, 1 / (variance x rays) is 0.05 (0.01 to 0.09) times that of the solutions.");
  PictureRecord second = picture("b", {});
  second.efficiency = record::Estimate{0.3, 0.2, 0.4};
  part(record_, 3).pictures.push_back(second);
  EXPECT_DOUBLE_EQ(pointsOf(1.0, 0.9, 1.1), 2.0);  // the least efficient counts
}

TEST_F(Marking, EfficiencyCountsAsFarAsThePartIsRight) {
  useSimpleRubric();
  rubric_.parts[0].points = 16.0;
  rubric_.parts[0].efficiency = 4.0;
  function(record_, "3.1").verdict = Verdict::kNotWritten;
  EXPECT_NEAR(lineOf(mark(), "efficiency").points, 4.0 * 2.0 / 3.0, 1e-12);
  for (const char* section : {"3.2", "3.3"})
    function(record_, section).verdict = Verdict::kNotWritten;
  part(record_, 3).pictures.clear();
  EXPECT_EQ(mark().points, 0.0);
  EXPECT_TRUE(mark().toReview.empty());
}

TEST_F(Marking, EfficiencyThatWasNotMeasuredCostsNothing) {
  part(record_, 3).pictures.clear();
  const Marks marks = mark();
  EXPECT_EQ(marks.points, 100.0);
  ASSERT_EQ(marks.toReview.size(), 1u);
  EXPECT_NE(marks.toReview[0].find("was not measured"), std::string::npos);
}

TEST_F(Marking, TheWholeIsMarkedByItsPictures) {
  const auto points = [&] { return marksOf(mark(), kWholePart).points; };
  record_.pictures[0].bias = {0.1, 0.08, 0.12};
  EXPECT_EQ(points(), 1.5);  // 0.4 of 4, to halves
  record_.pictures[0].bias = {0.001, 0.0, 0.002};
  record_.images[0].verdict = Verdict::kWrong;
  EXPECT_EQ(points(), 3.0);  // 0.8 of 4, to halves
  record_.pictures[0].failure = "part 3 does not compile";
  EXPECT_EQ(points(), 0.0);
  record_.pictures.clear();
  record_.images.clear();
  EXPECT_EQ(points(), 0.0);
}

constexpr const char* kInvalid = "16 % of its values are no radiance (45946 NaN)";

TEST_F(Marking, APictureWithInvalidValuesEarnsAsMuchAsNoneAndNoMoreThanItsBias) {
  useSimpleRubric();
  fail(function(record_, "3.1"));
  fail(function(record_, "3.3"), "samples", Verdict::kBlocked);
  PictureRecord& shown = part(record_, 3).pictures[0];
  for (const double bias : {0.0, 0.02, 0.1, 0.25, 0.5, 0.9}) {
    shown.bias = {bias, bias, bias};
    shown.invalid = {};
    const double valid = lineOf(mark(), "3.1").points;
    shown.invalid = kInvalid;
    for (const char* section : {"3.1", "3.3"})
      EXPECT_DOUBLE_EQ(lineOf(mark(), section).points,
                       std::min(valid, 4.0 * rubric_.withoutPicture))
          << bias;
  }
}

TEST_F(Marking, TheReasonSaysHowMuchOfAPictureIsInvalid) {
  fail(function(record_, "3.1"));
  // Far less than what the invalid values cost.
  part(record_, 3).pictures.push_back(picture("dim", {0.03, 0.02, 0.04}));
  part(record_, 3).pictures[0].invalid = record_.pictures[0].invalid = kInvalid;
  const std::string words =
      "he picture of a room is 0.1 % (0 % to 0.3 %) off, and 16 % of its values are no radiance "
      "(45946 NaN).";
  expectReason(mark(), "3.1", words);
  expectReason(mark(), "pictures of all parts together", words);
  EXPECT_EQ(marksOf(mark(), kWholePart).points, 1.0);  // 0.3 of 4, to halves
}

TEST_F(Marking, WhatIsBlockedLeavesTheWholeToItsPictures) {
  record_.images[0].verdict = Verdict::kBlocked;
  record_.images[0].cause = "part 4: 4.1 phongBRDF::brdf";
  EXPECT_EQ(marksOf(mark(), kWholePart).points, 4.0);
  record_.pictures[0].bias = {0.1, 0.08, 0.12};
  EXPECT_EQ(marksOf(mark(), kWholePart).points, 1.5);  // 0.4 of 4, to halves
  const std::string reason = lineOf(mark(), "pictures of all parts together").reason;
  EXPECT_EQ(reason,
            "The picture of a room is 10 % (8 % to 12 %) off. That earns 40 % of the points.");
  record_.pictures.clear();
  EXPECT_EQ(marksOf(mark(), kWholePart).points, 0.0);
  expectReason(mark(), "pictures of all parts together", "4.1 phongBRDF::brdf");
}

}  // namespace
}  // namespace pathmark::rubric
