// What a person is asked to look at, and what is said of files that were not taken.
#include "support/made_record.h"

namespace pathmark::rubric {
namespace {

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

TEST_F(Marking, TheEfficiencyOfAWrongPictureIsNotForReview) {
  PictureRecord& shown = part(record_, 5).pictures[0];
  shown.efficiency = record::Estimate{1e6, 1e6, 1e6};
  EXPECT_EQ(mark().toReview.size(), 1u);
  shown.bias = {0.02, 0.01, 0.03};
  EXPECT_TRUE(mark().toReview.empty());
  shown.bias = {};
  shown.invalid = "1 % of its values are no radiance (5 NaN)";
  EXPECT_TRUE(mark().toReview.empty());
}

TEST_F(Marking, WhatRanOutOfTimeIsForReview) {
  record_.outOfTime = true;
  ASSERT_EQ(mark().toReview.size(), 1u);
  EXPECT_NE(mark().toReview[0].find("--time-limit"), std::string::npos);
}

class LostFiles : public Marking {
 protected:
  void lose(int number) {
    PartRecord& lost = part(record_, number);
    lost.verdict = Verdict::kNotWritten;
    lost.functions.clear();
    lost.pictures.clear();
  }
};

TEST_F(LostFiles, AFileThatWasRefusedOrIgnoredIsForReviewAndItsReasonSaysSo) {
  for (const std::string remark :
       {"part2_lights.cpp was refused: it is larger than 1 MiB.",
        "work/Part2_lights.cpp was refused: it is a link, and links are not followed.",
        "part2_lights.cpp was refused: it was handed in 2 times with different contents (a, b).",
        "\"../part2_lights.cpp\" was refused: it leads out of the submission.",
        "part2_lights (1).cpp was ignored: this is not the name of a file of the coursework.",
        "work/part2.cpp was ignored: this is not the name of a file of the coursework."}) {
    record_ = rightRecord();
    lose(2);
    record_.collecting = {"1 other file was ignored: only part*.cpp and scenes/ are taken.", remark,
                          "part2_lights.cpp is missing."};
    const Marks marks = mark();
    ASSERT_EQ(marks.toReview.size(), 1u) << remark;
    EXPECT_EQ(marks.toReview[0],
              "Part 2 counts as not written, but something was handed in: " + remark);
    EXPECT_EQ(lineOf(marks, "2.4").reason, remark);
    EXPECT_EQ(marksOf(marks, 2).points, 0.0);
  }
}

TEST_F(LostFiles, AFileThatNobodyHandedInIsMissingAndNotForReview) {
  lose(2);
  record_.collecting = {"part2_lights.cpp is missing.",
                        "part3 (1).cpp was ignored: this is not the name of a file of the "
                        "coursework."};
  const Marks marks = mark();
  EXPECT_TRUE(marks.toReview.empty());
  EXPECT_EQ(lineOf(marks, "2.4").reason, "There is no part2_lights.cpp in the submission.");
}

TEST_F(LostFiles, AStubIsNotMissing) {
  for (FunctionRecord& f : part(record_, 2).functions) f.verdict = Verdict::kNotWritten;
  part(record_, 2).verdict = Verdict::kNotWritten;
  EXPECT_EQ(lineOf(mark(), "2.4").reason, "It is not written yet.");
}

TEST_F(LostFiles, ABonusPartThatWasRefusedIsForReview) {
  std::erase_if(record_.parts, [](const PartRecord& p) { return p.part == 8; });
  record_.collecting = {"part8_mis.cpp was refused: it is larger than 1 MiB."};
  EXPECT_EQ(mark().toReview.size(), 1u);
}

TEST_F(LostFiles, ASceneThatWasRefusedIsForReviewWhereThereIsNoOther) {
  record_.refusedScenes = {"scenes/a:b.json was refused: of its name."};
  EXPECT_TRUE(mark().toReview.empty());
  record_.scenes.clear();
  ASSERT_EQ(mark().toReview.size(), 1u);
  EXPECT_NE(mark().toReview[0].find("scenes/a:b.json was refused"), std::string::npos);
}

}  // namespace
}  // namespace pathmark::rubric
