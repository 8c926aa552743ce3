// Marks from records that are made up here.
#include "rubric/rubric.h"
#include "worker/contract.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace pathmark::rubric {
namespace {

using record::CheckRecord;
using record::FunctionRecord;
using record::PartRecord;
using record::PictureRecord;
using record::SubmissionRecord;
using record::Verdict;

PictureRecord picture(const std::string& scene, const record::Estimate& bias) {
  PictureRecord picture;
  picture.scene = scene;
  picture.bias = bias;
  picture.efficiency = record::Estimate{1.0, 0.9, 1.1};
  return picture;
}

// Of a submission in which everything is right.
SubmissionRecord rightRecord() {
  SubmissionRecord record;
  for (const PartContract& contractPart : parts()) {
    PartRecord part;
    part.part = contractPart.part;
    for (const FunctionContract& function : contract())
      if (function.part == part.part)
        part.functions.push_back(
            {std::string(function.section), std::string(function.name), Verdict::kOk, {}});
    part.pictures.push_back(picture("a room", {0.001, 0.0, 0.003}));
    record.parts.push_back(part);
  }
  record.images.push_back({});
  record.pictures.push_back(picture("a room", {0.001, 0.0, 0.003}));
  record.scenes.push_back({});
  record.scenes.back().file = "scenes/my_scene.json";
  return record;
}

FunctionRecord& function(SubmissionRecord& record, const std::string& section) {
  for (PartRecord& part : record.parts)
    for (FunctionRecord& f : part.functions)
      if (f.section == section) return f;
  throw std::runtime_error("no function " + section);
}

PartRecord& part(SubmissionRecord& record, int number) {
  return record.parts.at(static_cast<std::size_t>(number));
}

void fail(FunctionRecord& f, const std::string& check = "valid",
          Verdict verdict = Verdict::kWrong) {
  f.verdict = verdict;
  CheckRecord failed;
  failed.id = f.section + "/" + check;
  failed.verdict = verdict;
  f.checks.push_back(failed);
}

const PartMarks& marksOf(const Marks& marks, int number) {
  for (const PartMarks& p : marks.parts)
    if (p.part == number) return p;
  throw std::runtime_error("no marks of the part");
}

const MarkLine& lineOf(const Marks& marks, const std::string& begin) {
  for (const PartMarks& p : marks.parts)
    for (const MarkLine& line : p.lines)
      if (line.what.starts_with(begin)) return line;
  throw std::runtime_error("no line " + begin);
}

void expectReason(const Marks& marks, const std::string& line, const std::string& words) {
  EXPECT_NE(lineOf(marks, line).reason.find(words), std::string::npos)
      << lineOf(marks, line).reason;
}

class Marking : public testing::Test {
 protected:
  Marks mark() const { return markSubmission(record_, rubric_); }
  // Part 3 without efficiency: three functions of 4 points.
  void useSimpleRubric() {
    rubric_ = {};
    rubric_.parts = {{3, 12.0, 0.0, {}, {}}};
    rubric_.step = 0.0;
  }

  Rubric rubric_ = readRubric(defaultRubric());
  SubmissionRecord record_ = rightRecord();
};

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
  function(record_, "3.3").checks.clear();
  fail(function(record_, "3.3"), "valid");
  EXPECT_DOUBLE_EQ(lineOf(mark(), "3.3").points, 0.0);  // not below
}

TEST_F(Marking, WeightsShareThePointsOfAPart) {
  useSimpleRubric();
  rubric_.parts[0].weights = {{"3.1", 0.0}, {"3.3", 3.0}};
  const Marks marks = mark();
  EXPECT_DOUBLE_EQ(lineOf(marks, "3.1").outOf, 0.0);
  EXPECT_DOUBLE_EQ(lineOf(marks, "3.2").outOf, 3.0);
  EXPECT_DOUBLE_EQ(lineOf(marks, "3.3").outOf, 9.0);
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

TEST_F(Marking, AnEfficiencyBeyondBeliefIsForReview) {
  part(record_, 5).pictures[0].efficiency = record::Estimate{3.5, 2.9, 4.0};
  EXPECT_TRUE(mark().toReview.empty());
  part(record_, 5).pictures[0].efficiency = record::Estimate{3.5, 3.1, 4.0};
  const Marks marks = mark();
  EXPECT_EQ(marks.points, 100.0);
  ASSERT_EQ(marks.toReview.size(), 1u);
  EXPECT_NE(marks.toReview[0].find("Part 5: in a room it is 3.5 (3.1 to 4) times as efficient"),
            std::string::npos)
      << marks.toReview[0];
}

TEST_F(Marking, AForbiddenCallIsForReview) {
  fail(function(record_, "4.1"), "valid", Verdict::kForbiddenCall);
  const Marks marks = mark();
  EXPECT_LT(marks.points, 100.0);
  ASSERT_EQ(marks.toReview.size(), 1u);
  EXPECT_NE(marks.toReview[0].find("4.1 phongBRDF::brdf: it made a forbidden call"),
            std::string::npos);
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
  EXPECT_EQ(points({Verdict::kNotWritten}), 0.0);
  EXPECT_EQ(points({Verdict::kWrong}), 0.0);
  EXPECT_EQ(marksOf(mark(), kScenesPart).lines[0].reason, "a.json: There is no camera.");
  EXPECT_EQ(points({}), 0.0);
  EXPECT_EQ(marksOf(mark(), kScenesPart).lines[0].reason, "There is no scene in scenes/.");
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
