// A study of one mistake: each seed finds it, and after the first with one check.
#include "study/study.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace pathmark::study {
namespace {

using test::TemporaryFolder;

Variant variantNamed(const std::string& name) {
  const std::vector<Variant> all = allVariants();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Variant& v) { return v.name == name; });
  if (found == all.end()) throw std::invalid_argument(name);
  return *found;
}

std::vector<StudyRecord> run(const StudySubject& subject, int seeds, StudyLog& log, int& made) {
  made = 0;
  return runStudy({subject}, seeds, 1, log, [&](const StudyProgress&) {
    ++made;
    return true;
  });
}

TEST(RunStudy, LaterSeedsOfAMistakeTakeTheCheckThatFoundItAndNoOther) {
  const TemporaryFolder folder;
  StudyLog log(folder / "records.jsonl");
  int made = 0;
  const std::vector<StudyRecord> records =
      run(variantSubject(variantNamed("part2_cosine_at_light_missing"), false, folder / "scratch"),
          3, log, made);
  ASSERT_EQ(records.size(), 3u);
  EXPECT_GT(records[0].failed.size(), 1u) << "the first seed takes all checks";
  for (std::size_t k = 1; k < 3; ++k) {
    EXPECT_EQ(records[k].failed, std::vector<std::string>{records[0].failed.front()});
    EXPECT_LT(records[k].statistics, records[0].statistics);
  }
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
  EXPECT_EQ(records[1].failed, std::vector<std::string>{records[0].failed.front()})
      << "the check that found it is known from the log";
}

}  // namespace
}  // namespace pathmark::study
