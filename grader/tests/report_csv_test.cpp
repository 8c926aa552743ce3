// marks.csv: what spreadsheets may do with it.

#include "report/marks_csv.h"
#include "support/hostile.h"
#include "support/sample_record.h"

#include <fmt/format.h>

#include <gtest/gtest.h>

#include <array>

namespace pathmark {

namespace {

using report::csvCell;
using report::marksCsv;
using Rows = std::vector<std::vector<std::string>>;

// RFC 4180: quotes are doubled inside of quotes, lines end with CR LF.
Rows readCsv(const std::string& text) {
  Rows rows{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& cell = rows.back().back();
    if (quoted && text.compare(i, 2, "\"\"") == 0) {
      cell += '"';
      ++i;
    } else if (text[i] == '"') {
      EXPECT_TRUE(quoted || cell.empty()) << "a quote inside of a plain cell: " << cell;
      quoted = !quoted;
    } else if (!quoted && text[i] == ',') {
      rows.back().emplace_back();
    } else if (!quoted && text.compare(i, 2, "\r\n") == 0) {
      rows.push_back({""});
      ++i;
    } else {
      EXPECT_TRUE(quoted || (text[i] != '\n' && text[i] != '\r'));
      cell += text[i];
    }
  }
  EXPECT_FALSE(quoted);
  EXPECT_EQ(rows.back(), std::vector<std::string>{""}) << "the last line has no end";
  rows.pop_back();
  return rows;
}

std::string column(const Rows& rows, std::size_t row, const std::string& name) {
  for (std::size_t i = 0; i < rows[0].size(); ++i)
    if (rows[0][i] == name) return rows[row][i];
  ADD_FAILURE() << "no column " << name;
  return {};
}

TEST(CsvCell, QuotesOnlyWhereItMust) {
  EXPECT_EQ(csvCell("anna"), "anna");
  EXPECT_EQ(csvCell("a,b"), "\"a,b\"");
  EXPECT_EQ(csvCell("say \"hi\""), "\"say \"\"hi\"\"\"");
  EXPECT_EQ(csvCell("two\nlines"), "two lines");
}

TEST(CsvCell, DefusesFormulas) {
  EXPECT_EQ(csvCell("=1+1"), "\"'=1+1\"");
  for (const std::string text :
       {"=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1", "\n=1", "  =1", "\"=1", "\" =1,2",
        "=HYPERLINK(\"x\",\"y\")", "\uFF1D1", "\uFF20x", "=cmd|' /C calc'!A0"}) {
    const std::string cell = readCsv(csvCell(text) + "\r\n")[0][0];
    const bool harmless = cell.starts_with("'") || cell.starts_with("\u240D");
    EXPECT_TRUE(harmless) << text << " became " << cell;
  }
}

TEST(MarksCsv, HasARowForEachSubmissionAndAllColumnsInEach) {
  const test::SampleClass c = test::sampleClass();
  const Rows rows = readCsv(marksCsv(c.graded()));
  ASSERT_EQ(rows.size(), 1 + c.records.size());
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  EXPECT_EQ(column(rows, 1, "name"), "anna_complete");
  EXPECT_EQ(column(rows, 1, "total"), "70.5");
  EXPECT_EQ(column(rows, 1, "out of"), "73");
  EXPECT_EQ(column(rows, 2, "part 3"), "7.25");
  EXPECT_EQ(column(rows, 2, "part 3 out of"), "9");
  EXPECT_EQ(column(rows, 2, "part 4 verdict"), "does not compile");
  EXPECT_EQ(column(rows, 2, "seed"), "4711");
}

TEST(MarksCsv, EndsWithTheFolderOrArchiveThatWasHandedIn) {
  test::SampleClass c = test::sampleClass();
  const std::vector<std::array<std::string, 3>> cases{
      {"M\u00fcller_Anna", "/class/M\u00fcller, Anna", "M\u00fcller, Anna"},
      {"Alex_Kim", "/class/Alex Kim", "Alex Kim"},
      {"Alex_Kim-2", "/class/Alex Kim.tar.gz", "Alex Kim.tar.gz"},
      {"Jo_12_file_", "/class/Jo_12_file_/student.zip", "Jo_12_file_/student.zip"},
      {"task-9", "/class/task-9/", "task-9"}};
  for (std::size_t i = 0; i < cases.size(); ++i)
    c.records[i].name = cases[i][0], c.records[i].source = cases[i][1];
  const Rows rows = readCsv(marksCsv(c.graded()));
  EXPECT_EQ(rows[0].back(), "submission");
  for (std::size_t i = 0; i < cases.size(); ++i) EXPECT_EQ(rows[i + 1].back(), cases[i][2]);
}

TEST(MarksCsv, SaysNothingTwice) {
  test::SampleClass c = test::sampleClass();
  c.records[0].contents = "its own";
  c.records[0].collecting = {"a.cpp was refused.", "b.cpp is missing."};
  c.marks[0].toReview = {"Look: a.cpp was refused."};
  const Rows rows = readCsv(marksCsv(c.graded()));
  EXPECT_EQ(column(rows, 1, "remarks"), "Look: a.cpp was refused. b.cpp is missing.");
}

TEST(MarksCsv, SaysWhoHasTheSameFiles) {
  test::SampleClass c = test::sampleClass();
  for (record::SubmissionRecord& record : c.records) record.contents = record.name;
  for (const std::size_t copy : {0u, 1u, 3u}) c.records[copy].contents = "the same";
  c.records[4].contents = "the same";  // was not graded
  const Rows rows = readCsv(marksCsv(c.graded()));
  const auto remarks = [&](std::size_t row) { return column(rows, row, "remarks"); };
  EXPECT_TRUE(remarks(1).starts_with("The same files as in ben_of_all_sorts and dora_nearly."))
      << remarks(1);
  EXPECT_TRUE(remarks(2).starts_with("The same files as in anna_complete and dora_nearly."));
  EXPECT_TRUE(remarks(4).starts_with("The same files as in anna_complete and ben_of_all_sorts."));
  for (const std::size_t row : {3u, 5u})
    EXPECT_EQ(remarks(row).find("The same files"), std::string::npos) << remarks(row);
}

TEST(MarksCsv, TakesNoStubsForCopies) {
  test::SampleClass c = test::sampleClass();
  for (record::SubmissionRecord& record : c.records)
    for (record::PartRecord& part : record.parts) {
      part.verdict = record::Verdict::kNotWritten;
      for (record::FunctionRecord& function : part.functions)
        function.verdict = record::Verdict::kNotWritten;
    }
  EXPECT_EQ(marksCsv(c.graded()).find("The same files"), std::string::npos);
  // Without their markers.
  for (record::SubmissionRecord& record : c.records)
    for (record::FunctionRecord& function : record.parts.at(3).functions)
      function.verdict = record::Verdict::kWrong, function.mistake = "stub";
  EXPECT_EQ(marksCsv(c.graded()).find("The same files"), std::string::npos);
  for (const std::size_t copy : {0u, 1u})
    c.records[copy].parts.at(4).verdict = record::Verdict::kDoesNotCompile,
    c.records[copy].parts.at(4).functions.clear();
  EXPECT_NE(marksCsv(c.graded()).find("The same files as in ben_of_all_sorts."), std::string::npos);
}

TEST(MarksCsv, NamesNotEverybodyOfManyWithTheSameFiles) {
  test::SampleClass c = test::sampleClass();
  const record::SubmissionRecord one = c.records[0];
  c.records.assign(9, one);
  c.marks.assign(9, c.marks[0]);
  for (std::size_t i = 0; i < c.records.size(); ++i) c.records[i].name = fmt::format("s{}", i);
  EXPECT_NE(marksCsv(c.graded()).find("The same files as in s1, s2, s3, s4, s5 and 3 others."),
            std::string::npos);
}

TEST(MarksCsv, SaysWhyAPictureIsMissingOnce) {
  test::SampleClass c = test::sampleClass();
  c.records[0].contents = "its own";
  record::PictureRecord& lost = c.records[0].parts.at(5).pictures.at(0);
  lost.failure = "The coursework printed more than 1024 KiB and was stopped.";
  c.marks[0].toReview = {"Part 5: its efficiency was not measured."};
  EXPECT_EQ(column(readCsv(marksCsv(c.graded())), 1, "remarks"),
            "Part 5: its efficiency was not measured. Part 5: there is no picture of cornell_box: "
            "The coursework printed more than 1024 KiB and was stopped.");
  c.marks[0].toReview = {"Part 5: not measured: " + lost.failure};
  EXPECT_EQ(column(readCsv(marksCsv(c.graded())), 1, "remarks"),
            "Part 5: not measured: " + lost.failure);
}

TEST(MarksCsv, GivesNoPointsToWhatCouldNotBeGraded) {
  const test::SampleClass c = test::sampleClass();
  const Rows rows = readCsv(marksCsv(c.graded()));
  EXPECT_EQ(column(rows, 5, "total"), "");
  EXPECT_EQ(column(rows, 5, "part 1"), "");
  EXPECT_NE(column(rows, 5, "remarks").find("no space left"), std::string::npos);
}

TEST(MarksCsv, TellsWhatWasLeftOutFromWhatEarnedNothing) {
  test::SampleClass c = test::sampleClass();
  c.add(test::leftOutRecord("fay"));
  const Rows rows = readCsv(marksCsv(c.graded()));
  ASSERT_EQ(rows.size(), 7u);
  EXPECT_EQ(rows[6].size(), rows[0].size());
  EXPECT_EQ(column(rows, 6, "name"), "fay");
  EXPECT_EQ(column(rows, 6, "total"), "");
  EXPECT_EQ(column(rows, 6, "part 3"), "");
  EXPECT_EQ(column(rows, 6, "out of"), "73");
  EXPECT_EQ(column(rows, 6, "part 3 out of"), "9");
  EXPECT_EQ(column(rows, 6, "remarks"), "No marks: Nothing was taken: the archive is damaged.");
}

TEST(MarksCsv, SurvivesHostileTexts) {
  test::SampleClass c = test::sampleClass();
  for (record::SubmissionRecord& record : c.records) {
    record = test::withHostileTexts(record);
    record.name.insert(0, 1, '=');
    record.collecting = {test::hostileText("@collecting")};
  }
  const Rows rows = readCsv(marksCsv(c.graded()));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].size(), rows[0].size());
    for (const std::string& cell : rows[i])
      EXPECT_EQ(cell.find_first_of("=+-@\t\r\n"),
                cell.empty() ? std::string::npos : cell.find_first_of("=+-@\t\r\n", 1))
          << cell;
  }
}

}  // namespace

}  // namespace pathmark
