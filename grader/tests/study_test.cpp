// A study of one mistake: each seed finds it, and after the first with the check that it names. A
// mistake that another check finds is not as it must be.
#include "study/study.h"
#include "study/kill_table.h"
#include "support/test_coursework_files.h"
#include "support/variant_named.h"

#include <gtest/gtest.h>

#include <utility>

namespace pathmark::study {
namespace {

using test::TemporaryFolder;
using test::variantNamed;

std::vector<StudyRecord> run(const StudySubject& subject, int seeds, StudyLog& log, int& made) {
  made = 0;
  return runStudy({subject}, seeds, 1, log, [&](const StudyProgress&) {
    ++made;
    return true;
  });
}

TEST(RunStudy, LaterSeedsOfAMistakeTakeTheCheckThatItNamesAndNoOther) {
  const TemporaryFolder folder;
  StudyLog log(folder / "records.jsonl");
  int made = 0;
  const StudySubject subject =
      variantSubject(variantNamed("part2_cosine_at_light_missing"), false, folder / "scratch");
  const std::vector<StudyRecord> records = run(subject, 3, log, made);
  ASSERT_EQ(records.size(), 3u);
  EXPECT_GT(records[0].failed.size(), 1u) << "the first seed takes all checks";
  for (std::size_t k = 1; k < 3; ++k) {
    EXPECT_EQ(records[k].failed, std::vector<std::string>{subject.variant->check});
    EXPECT_LT(records[k].statistics, records[0].statistics);
  }
}

TEST(RunStudy, WhereTheCheckThatIsNamedFindsNothingTheOthersAreAsked) {
  const TemporaryFolder folder;
  Variant variant = variantNamed("part6_no_weight");
  const std::string finder = std::exchange(variant.check, "6.1/ends");
  StudyLog log(folder / "records.jsonl");
  int made = 0;
  const StudySubject subject = variantSubject(variant, false, folder / "scratch");
  const std::vector<StudyRecord> records = run(subject, 2, log, made);
  ASSERT_EQ(records.size(), 2u);
  for (const StudyRecord& record : records)
    EXPECT_EQ(record.failed, std::vector<std::string>{finder});
  EXPECT_FALSE(killTable({subject}, records, {}).at(0).asItMustBe());
}

TEST(RunStudy, WhatIsInTheLogIsNotRunAgain) {
  const TemporaryFolder folder;
  const StudySubject subject =
      variantSubject(variantNamed("part6_no_weight"), false, folder / "scratch");
  int made = 0;
  {
    StudyLog log(folder / "records.jsonl");
    run(subject, 1, log, made);
    EXPECT_EQ(made, 1);
  }
  StudyLog log(folder / "records.jsonl");
  const std::vector<StudyRecord> records = run(subject, 2, log, made);
  EXPECT_EQ(made, 1);
  ASSERT_EQ(records.size(), 2u);
}

// The row of part6_no_weight, if this is what the checks said of it.
KillRow rowOf(const std::vector<std::vector<std::string>>& failed) {
  StudySubject subject;
  subject.variant = variantNamed("part6_no_weight");
  subject.name = subject.variant->name;
  std::vector<StudyRecord> records;
  for (std::size_t k = 0; k < failed.size(); ++k) {
    StudyRecord record;
    record.subject = subject.name;
    record.seed = k + 1;
    record.failed = failed[k];
    records.push_back(record);
  }
  return killTable({subject}, records, {}).at(0);
}

TEST(KillRow, IsAsItMustBeIfEachSeedIsFoundByTheCheckThatThePatchNames) {
  const std::string its = variantNamed("part6_no_weight").check;
  EXPECT_TRUE(rowOf({{its}}).asItMustBe());
  EXPECT_TRUE(rowOf({{"6.1/other", its}, {its}}).asItMustBe()) << "others may fail before it";
  EXPECT_FALSE(rowOf({{its}, {}}).asItMustBe()) << "a seed finds nothing";
  EXPECT_FALSE(rowOf({{its}, {"part 6"}}).asItMustBe()) << "it does not even compile";

  const KillRow missed = rowOf({{its, "6.1/other"}, {"6.1/other"}});
  EXPECT_FALSE(missed.asItMustBe()) << "a seed finds it by another check";
  EXPECT_EQ(missed.found, 2);
  EXPECT_EQ(missed.byItsCheck, 1);
  const std::string text = asText({missed});
  EXPECT_NE(text.find(its + " (1 of 2; 6.1/other, 1)"), std::string::npos) << text;
  EXPECT_NE(text.find("<-- must not be"), std::string::npos) << text;
}

}  // namespace
}  // namespace pathmark::study
