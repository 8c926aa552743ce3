// Marks from records that are made up here: verdicts, prices, sums.
#include "diagnosis/diagnosis.h"
#include "support/made_record.h"

#include <cmath>
#include <random>

namespace pathmark::rubric {
namespace {

TEST_F(Marking, AllRightEarnsAllPoints) {
  const Marks marks = mark();
  EXPECT_EQ(marks.points, 100.0);
  EXPECT_EQ(marks.outOf, 100.0);
  EXPECT_EQ(marks.parts.size(), 9u);
  EXPECT_TRUE(marks.toReview.empty());
  for (const PartMarks& p : marks.parts)
    for (const MarkLine& line : p.lines) EXPECT_EQ(line.reason, "") << line.what;
}

TEST_F(Marking, AllRightEarnsAllPointsWhateverTheStepAndTheTotal) {
  for (const double step : {0.0, 0.1, 0.5, 1.0, 7.0})
    for (const double scale : {1.0 / 3.0, 0.2, 0.77}) {
      Rubric other = rubric_;
      other.step = step;
      for (PartRubric& p : other.parts) p.points *= scale, p.efficiency *= scale;
      const Marks marks = markSubmission(record_, other);
      EXPECT_EQ(marks.points, marks.outOf) << step << " " << scale;
    }
}

TEST_F(Marking, WhatCouldNotAllBeShownCostsNothing) {
  for (PartRecord& p : record_.parts)
    for (FunctionRecord& f : p.functions) f.verdict = Verdict::kUndecided;
  EXPECT_EQ(mark().points, 100.0);
}

TEST_F(Marking, EachVerdictIsWorthWhatTheRubricSays) {
  useSimpleRubric();
  rubric_.crashed = 0.1;
  rubric_.timeLimit = 0.2;
  rubric_.memoryLimit = 0.3;
  rubric_.outputLimit = 0.4;
  rubric_.forbiddenCall = 0.5;
  part(record_, 3).pictures = {picture("a room", {0.03, 0.02, 0.04})};
  const std::vector<std::tuple<Verdict, double, std::string>> cases{
      {Verdict::kOk, 1.0, ""},
      {Verdict::kUndecided, 1.0, ""},
      {Verdict::kInternalError, 1.0, ""},
      {Verdict::kNotWritten, 0.0, "not written yet"},
      {Verdict::kDoesNotCompile, 0.0, "does not compile"},
      {Verdict::kCrashed, 0.1, "crashed"},
      {Verdict::kTimeLimit, 0.2, "did not end within its time"},
      {Verdict::kMemoryLimit, 0.3, "more memory"},
      {Verdict::kOutputLimit, 0.4, "printed more"},
      {Verdict::kForbiddenCall, 0.5, "called the system"},
      {Verdict::kWrong, 0.8, "The picture of a room is 3 % (2 % to 4 %) off."},
      {Verdict::kBlocked, 0.8, "could not be checked"},
  };
  for (const auto& [verdict, credit, reason] : cases) {
    function(record_, "3.3").verdict = verdict;
    const Marks marks = mark();
    EXPECT_DOUBLE_EQ(lineOf(marks, "3.3").points, credit * 4.0) << reason;
    EXPECT_DOUBLE_EQ(marks.points, 8.0 + credit * 4.0) << reason;
    expectReason(marks, "3.3", reason);
    EXPECT_EQ(lineOf(marks, "3.3").reason.empty(), credit == 1.0);
  }
}

TEST_F(Marking, EfficiencyWithAllThePointsCountsAsFarAsTheFunctionsAreRight) {
  rubric_ = {};
  rubric_.parts = {{3, 12.0, 12.0, {}, {}}};
  rubric_.step = 0.0;
  EXPECT_EQ(mark().points, 12.0);
  function(record_, "3.3").verdict = Verdict::kNotWritten;
  EXPECT_DOUBLE_EQ(mark().points, 8.0);
  EXPECT_EQ(lineOf(mark(), "3.3").outOf, 0.0);
  for (FunctionRecord& f : part(record_, 3).functions) f.verdict = Verdict::kNotWritten;
  EXPECT_EQ(mark().points, 0.0);
  EXPECT_EQ(mark().outOf, 12.0);
}

// Where every picture hides it: a roulette that never ends a path is unbiased.
TEST_F(Marking, WhatAnswersAsTheStubEarnsNothing) {
  FunctionRecord& stub = function(record_, "6.1");
  fail(stub);
  part(record_, 6).pictures = {picture("a room", {0.0, 0.0, 0.001})};
  EXPECT_GT(lineOf(mark(), "6.1").points, 0.0);
  stub.mistake = diagnosis::kStub;
  EXPECT_EQ(lineOf(mark(), "6.1").points, 0.0);
  expectReason(mark(), "6.1",
               "It is not written yet: it answers as the empty stub does, whatever it is asked.");
}

TEST_F(Marking, AMistakeCostsItsPartOnly) {
  fail(function(record_, "3.3"));
  const Marks marks = mark(), right = markSubmission(rightRecord(), rubric_);
  for (const PartMarks& p : marks.parts)
    EXPECT_EQ(p.points == marksOf(right, p.part).points, p.part != 3) << p.part;
}

TEST_F(Marking, AFileThatDoesNotCompileHasNoPointsOfItsPart) {
  part(record_, 4).verdict = Verdict::kDoesNotCompile;
  part(record_, 4).functions.clear();
  part(record_, 4).pictures.clear();
  const Marks marks = mark();
  EXPECT_EQ(marksOf(marks, 4).points, 0.0);
  EXPECT_EQ(marks.points, 84.0);
  EXPECT_TRUE(marks.toReview.empty());
}

TEST_F(Marking, ChecksWithAPriceCostNoMore) {
  useSimpleRubric();
  rubric_.parts[0].checks = {{"3.3/repeatable", 0.5}, {"3.3/valid", 9.0}};
  part(record_, 3).pictures = {picture("a room", {0.9, 0.8, 1.0})};
  fail(function(record_, "3.3"), "repeatable");
  EXPECT_DOUBLE_EQ(lineOf(mark(), "3.3").points, 3.5);
  expectReason(mark(), "3.3", "Wrong in 3.3/repeatable, which costs 0.5 points.");
  fail(function(record_, "3.3"), "samples");  // which has no price
  EXPECT_DOUBLE_EQ(lineOf(mark(), "3.3").points, 0.0);
  part(record_, 3).pictures = {picture("a room", {0.0, 0.0, 0.0})};
  EXPECT_DOUBLE_EQ(lineOf(mark(), "3.3").points, 3.2);
  expectReason(mark(), "3.3", "80 % of the points, the most that what is not known to be right");
  rubric_.parts[0].checks["3.3/repeatable"] = 1.0;
  EXPECT_DOUBLE_EQ(lineOf(mark(), "3.3").points, 3.0);
  expectReason(mark(), "3.3", "But what has a price of its own costs 1 point.");
  function(record_, "3.3").checks.clear();
  fail(function(record_, "3.3"), "valid");
  EXPECT_DOUBLE_EQ(lineOf(mark(), "3.3").points, 0.0);  // not below
}

TEST_F(Marking, WhatIsBlockedByAMistakeWithAPriceCostsNothing) {
  useSimpleRubric();
  rubric_.parts[0].checks = {{"3.2/valid", 0.5}};
  part(record_, 3).pictures = {picture("a room", {0.9, 0.8, 1.0})};
  fail(function(record_, "3.2"), "valid");
  fail(function(record_, "3.3"), "samples", Verdict::kBlocked);
  EXPECT_DOUBLE_EQ(lineOf(mark(), "3.2").points, 3.5);
  EXPECT_DOUBLE_EQ(lineOf(mark(), "3.3").points, 4.0);
  fail(function(record_, "3.1"), "value");  // which has no price
  EXPECT_DOUBLE_EQ(lineOf(mark(), "3.3").points, 0.0);
}

TEST_F(Marking, WeightsShareThePointsOfAPart) {
  useSimpleRubric();
  rubric_.parts[0].weights = {{"3.1", 0.0}, {"3.3", 3.0}};
  const Marks marks = mark();
  EXPECT_DOUBLE_EQ(lineOf(marks, "3.1").outOf, 0.0);
  EXPECT_DOUBLE_EQ(lineOf(marks, "3.2").outOf, 3.0);
  EXPECT_DOUBLE_EQ(lineOf(marks, "3.3").outOf, 9.0);
}

TEST_F(Marking, TheGradersOwnFailureCostsNothing) {
  fail(function(record_, "4.1"), "valid", Verdict::kInternalError);
  record_.images[0].verdict = Verdict::kInternalError;
  record_.pictures[0].failure = "the machine has no memory left";
  const Marks marks = mark();
  EXPECT_EQ(marks.points, 100.0);
  EXPECT_EQ(marks.toReview.size(), 2u);
  // A record that ends early: what is not there is not counted.
  SubmissionRecord broken;
  broken.failure = "The disk is full.";
  const Marks none = markSubmission(broken, rubric_);
  EXPECT_EQ(none.outOf, 0.0);
  ASSERT_EQ(none.toReview.size(), 1u);
  EXPECT_NE(none.toReview[0].find("The disk is full."), std::string::npos);
}

TEST_F(Marking, APartThatWasNotGradedIsNotCounted) {
  SubmissionRecord one;
  one.parts = {part(record_, 6)};
  const Marks marks = markSubmission(one, rubric_);
  ASSERT_EQ(marks.parts.size(), 1u);
  EXPECT_EQ(marks.outOf, marksOf(mark(), 6).outOf);
  EXPECT_EQ(marks.points, marks.outOf);
}

TEST_F(Marking, BonusPartsComeOnTopAndLeavingThemOutCostsNothing) {
  PartRubric mis{8, 9.0, 0.0, {}, {}};
  mis.bonus = true;
  rubric_.parts.push_back(mis);
  EXPECT_EQ(mark().points, 109.0);
  EXPECT_EQ(mark().outOf, 100.0);
  fail(function(record_, "8.3"));
  EXPECT_LT(mark().points, 109.0);
  EXPECT_GT(mark().points, 100.0);
  std::erase_if(record_.parts, [](const PartRecord& p) { return p.part == 8; });
  EXPECT_EQ(mark().points, 100.0);
  EXPECT_EQ(mark().outOf, 100.0);
}

TEST_F(Marking, WhatWasNotGradedIsOutOfNothing) {
  SubmissionRecord leftOut;
  leftOut.leftOut = "It cannot be read.";
  const Marks marks = markSubmission(leftOut, rubric_);
  EXPECT_TRUE(marks.parts.empty());
  EXPECT_EQ(marks.outOf, 0.0);
}

TEST_F(Marking, OneGoodSceneIsEnough) {
  const auto points = [&](std::vector<Verdict> verdicts) {
    record_.scenes.clear();
    for (const Verdict verdict : verdicts) {
      record_.scenes.push_back({});
      record_.scenes.back().verdict = verdict;
      record_.scenes.back().file = "a.json";
      record_.scenes.back().message = "there is no camera";
    }
    return marksOf(mark(), kScenesPart).points;
  };
  EXPECT_EQ(points({Verdict::kWrong, Verdict::kOk}), 4.0);
  EXPECT_EQ(points({Verdict::kBlocked}), 4.0);  // by the parts, which have cost already
  EXPECT_EQ(
      marksOf(mark(), kScenesPart).lines[0].reason,
      "a.json was not rendered, blocked by there is no camera; as far as it was read it is right.");
  EXPECT_EQ(points({Verdict::kNotWritten}), 0.0);
  EXPECT_EQ(points({Verdict::kWrong}), 0.0);
  EXPECT_EQ(marksOf(mark(), kScenesPart).lines[0].reason, "a.json: There is no camera.");
  EXPECT_EQ(points({}), 0.0);
  EXPECT_EQ(marksOf(mark(), kScenesPart).lines[0].reason, "There is no scene in scenes/.");
}

TEST_F(Marking, WhereTimeWasUpAMissingSceneMayHaveBeenThere) {
  record_.scenes.clear();
  record_.outOfTime = true;
  EXPECT_NE(marksOf(mark(), kScenesPart).lines[0].reason.find("or the time"), std::string::npos);
}

TEST_F(Marking, NamesTheRubricWhereItIsNotTheDefaultOne) {
  EXPECT_EQ(mark().rubric, "");
  rubric_.file = "mine.json";
  EXPECT_EQ(mark().rubric, "mine.json");
}

TEST_F(Marking, ASceneThatWasRefusedIsNotCalledMissingWhateverTheWords) {
  const std::string refused = "a:b was not taken.";
  record_.scenes.clear();
  record_.collecting = {"work/scenes/b.json was refused: of another thing.", refused};
  record_.refusedScenes = {refused};
  const MarkLine line = marksOf(mark(), kScenesPart).lines[0];
  EXPECT_EQ(line.points, 0.0);
  EXPECT_EQ(line.reason, refused);
}

// Lines to parts, parts to the total, whatever went wrong.
TEST_F(Marking, PointsAddUp) {
  std::mt19937 random(7);
  const auto uniform = [&] { return std::uniform_real_distribution<>(0.0, 1.0)(random); };
  for (int round = 0; round < 500; ++round) {
    record_ = rightRecord();
    for (PartRecord& p : record_.parts) {
      for (FunctionRecord& f : p.functions)
        if (uniform() < 0.4) f.verdict = static_cast<Verdict>(random() % 12);
      const double bias = std::pow(uniform(), 4.0);
      p.pictures = {picture("a", {bias, 0.9 * bias, 1.1 * bias})};
      p.pictures[0].efficiency = record::Estimate{bias, 0.5 * bias, 2.0 * bias};
    }
    const Marks marks = mark();
    double points = 0.0, outOf = 0.0;
    for (const PartMarks& p : marks.parts) {
      double sum = 0.0, most = 0.0;
      for (const MarkLine& line : p.lines) {
        sum += line.points, most += line.outOf;
        if (line.what == "rounding") continue;
        EXPECT_GE(line.points, 0.0);
        EXPECT_LE(line.points, line.outOf);
        EXPECT_EQ(line.points == line.outOf, line.reason.empty()) << line.what;
      }
      EXPECT_NEAR(sum, p.points, 1e-9);
      EXPECT_NEAR(most, p.outOf, 1e-9);
      EXPECT_GE(p.points, 0.0);
      EXPECT_LE(p.points, p.outOf);
      EXPECT_EQ(p.points, std::round(2.0 * p.points) / 2.0);
      points += p.points, outOf += p.outOf;
    }
    EXPECT_EQ(points, marks.points);
    EXPECT_EQ(outOf, 100.0);
  }
}

}  // namespace
}  // namespace pathmark::rubric
