// Marks of what is correct: which losses are as they must be, and that a variant is judged once.
#include "study/marks_study.h"
#include "support/test_coursework_files.h"
#include "support/variant_named.h"
#include "worker/contract.h"

#include <gtest/gtest.h>

namespace pathmark::study {
namespace {

using record::Verdict;
using test::TemporaryFolder;
using test::variantNamed;

const rubric::Rubric& worth() {
  static const rubric::Rubric rubric = withBonusParts(rubric::readRubric(rubric::defaultRubric()));
  return rubric;
}

// Of a submission in which all of the part is right, and as efficient as this.
record::SubmissionRecord recordOf(int part, const record::Estimate& efficiency) {
  record::SubmissionRecord record;
  record::PartRecord made;
  made.part = part;
  for (const FunctionContract& f : contract())
    if (f.part == part)
      made.functions.push_back({std::string(f.section), std::string(f.name), Verdict::kOk, {}});
  record::PictureRecord picture;
  picture.scene = "a room";
  picture.efficiency = efficiency;
  made.pictures.push_back(picture);
  record.parts.push_back(made);
  return record;
}

const record::Estimate kAsTheSolutions{1.0, 0.9, 1.1}, kLess{0.6, 0.55, 0.65};

TEST(VariantMarks, OfAllPointsAreAsTheyMustBe) {
  const VariantMarks marks =
      marksOf(variantNamed("part3_own_frame"), recordOf(3, kAsTheSolutions), worth());
  EXPECT_TRUE(marks.asItMustBe());
  EXPECT_EQ(marks.part.points, marks.part.outOf);
  EXPECT_EQ(marks.correctness.outOf + marks.efficiency.outOf, marks.part.outOf);
  EXPECT_TRUE(marks.reasons.empty());
}

TEST(VariantMarks, ThatLoseEfficiencyMustDoSoOnPurpose) {
  Variant variant = variantNamed("part3_own_frame");
  const VariantMarks lost = marksOf(variant, recordOf(3, kLess), worth());
  EXPECT_TRUE(lost.correctness.all());
  EXPECT_FALSE(lost.efficiency.all());
  EXPECT_FALSE(lost.asItMustBe());
  ASSERT_EQ(lost.reasons.size(), 1u);
  EXPECT_EQ(lost.reasons[0].find("efficiency: In a room"), 0u) << lost.reasons[0];
  const MarksReport report = reportMarks({lost});
  EXPECT_FALSE(report.asItMustBe);
  EXPECT_NE(report.text.find("<-- must not be"), std::string::npos) << report.text;

  variant.lessEfficient = "it is uniform";
  const VariantMarks meant = marksOf(variant, recordOf(3, kLess), worth());
  EXPECT_TRUE(meant.asItMustBe());
  EXPECT_TRUE(reportMarks({meant}).asItMustBe);
}

// A quarter of the one point for part 6's efficiency, where points are multiples of a half.
TEST(VariantMarks, ThatRoundingGivesBackAreNotLost) {
  const VariantMarks marks =
      marksOf(variantNamed("part6_largest_channel"), recordOf(6, kLess), worth());
  EXPECT_FALSE(marks.efficiency.all());
  EXPECT_TRUE(marks.part.all());
  EXPECT_TRUE(marks.asItMustBe());
}

TEST(VariantMarks, ThatLoseCorrectnessAreNeverAsTheyMustBe) {
  Variant variant = variantNamed("part3_own_frame");
  variant.lessEfficient = "it is uniform";
  record::SubmissionRecord record = recordOf(3, kAsTheSolutions);
  record.parts[0].functions[0].verdict = Verdict::kWrong;
  EXPECT_FALSE(marksOf(variant, record, worth()).asItMustBe());
}

// What the grader could not find out costs no points, and shows nothing.
TEST(VariantMarks, OfWhatWasNotFoundOutAreNotAsTheyMustBe) {
  const Variant variant = variantNamed("part3_own_frame");
  record::SubmissionRecord record = recordOf(3, kAsTheSolutions);
  record.parts[0].functions[0].verdict = Verdict::kInternalError;
  const VariantMarks marks = marksOf(variant, record, worth());
  EXPECT_EQ(marks.part.points, marks.part.outOf);
  EXPECT_FALSE(marks.asItMustBe());
  EXPECT_FALSE(marksOf(variant, {}, worth()).asItMustBe()) << "the part is not there at all";
}

TEST(VariantMarks, ThereAreForEachPartThatHasVariants) {
  for (const Variant& variant : allVariants()) {
    if (variant.wrong) continue;
    EXPECT_TRUE(marksOf(variant, recordOf(variant.part, kAsTheSolutions), worth()).asItMustBe())
        << variant.name;
  }
}

TEST(MarkVariants, JudgesEachOnceForASeed) {
  const TemporaryFolder folder;
  const std::vector<Variant> variants{variantNamed("part6_constant")};
  const MarksOptions options{.seeds = 1, .threads = 2, .folder = folder.path()};
  int asked = 0;
  const auto step = [&](std::size_t, std::size_t all) {
    ++asked;
    EXPECT_EQ(all, 1u);
    return true;
  };
  const std::vector<VariantMarks> first = markVariants(variants, worth(), options, step);
  ASSERT_EQ(first.size(), 1u);
  EXPECT_TRUE(first[0].asItMustBe()) << reportMarks(first).text;
  EXPECT_GT(asked, 1) << "judging asks too";
  asked = 0;
  const std::vector<VariantMarks> again = markVariants(variants, worth(), options, step);
  EXPECT_EQ(asked, 1) << "nothing is judged again";
  EXPECT_EQ(reportMarks(again).text, reportMarks(first).text);
}

TEST(MarkVariants, StopsWhereItIsToldTo) {
  const TemporaryFolder folder;
  int asked = 0;
  EXPECT_TRUE(markVariants({variantNamed("part6_constant")}, worth(),
                           {.seeds = 2, .threads = 1, .folder = folder.path()},
                           [&](std::size_t, std::size_t) { return ++asked < 3; })
                  .empty());
}

}  // namespace
}  // namespace pathmark::study
