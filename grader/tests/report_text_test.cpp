// Text from outside, and the table of a class.

#include "report/class_table.h"
#include "report/clean_text.h"
#include "report/field.h"
#include "report/html_text.h"
#include "support/hostile.h"
#include "support/sample_record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace pathmark {

namespace {

using report::classTable;
using report::cleanLine;
using report::cleanText;
using report::columnsOf;
using report::cutInMiddle;
using report::shownWords;

std::vector<std::string> linesOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(ShownWords, SayOfAnUndecidedCheckWhatItWouldHaveFound) {
  EXPECT_EQ(shownWords(true, 0.023, 0.01),
            "an error of 2.3 % would have been found, and 1 % should be");
  EXPECT_EQ(shownWords(false, 0.023, 0.01), "");
  EXPECT_EQ(shownWords(true, std::numeric_limits<double>::infinity(), 0.01), "");
}

TEST(CleanText, KeepsTextOfAllLanguages) {
  const std::string text = "Zo\xc3\xab \xce\xbb \xe5\xb1\xb1\xe7\x94\xb0 \xf0\x9f\x8e\xa8\n\tx";
  EXPECT_EQ(cleanText(text), text);
}

TEST(CleanText, ShowsControlCharactersAsPictures) {
  EXPECT_EQ(cleanText("a\x1b[31mb"), "a\u241B[31mb");
  EXPECT_EQ(cleanText(std::string_view("\0", 1)), "\u2400");
  EXPECT_EQ(cleanText("\x7f"), "\u2421");
  EXPECT_EQ(cleanText("a\r\nb\rc"), "a\nb\u240Dc");
}

TEST(CleanText, ReplacesWhatIsNoUtf8OrMisleads) {
  EXPECT_EQ(cleanText("\xff"), "\uFFFD");
  EXPECT_EQ(cleanText("\xc0\xaf"), "\uFFFD\uFFFD");                 // overlong
  EXPECT_EQ(cleanText("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD");       // a surrogate
  EXPECT_EQ(cleanText("\xf4\x90\x80\x80").substr(0, 3), "\uFFFD");  // beyond U+10FFFF
  EXPECT_EQ(cleanText("\xe2\x82"), "\uFFFD\uFFFD");                 // cut off
  EXPECT_EQ(cleanText("\u202E\u2066\u0085\uFFFF"), "\uFFFD\uFFFD\uFFFD\uFFFD");
}

TEST(CleanText, IsCleanAlready) {
  const std::string clean = cleanText(test::hostileText("x"));
  EXPECT_EQ(cleanText(clean), clean);
}

TEST(CutAfter, CutsNoCharacterInTwo) {
  EXPECT_EQ(report::cutAfter("abc", 3), "abc");
  EXPECT_EQ(report::cutAfter("a\u00e9\u00e9", 4), "a\u00e9\n... and 2 more bytes");
}

TEST(CutInMiddle, KeepsBothEndsWithinTheColumns) {
  EXPECT_EQ(cutInMiddle("anna_complete", 13), "anna_complete");
  EXPECT_EQ(cutInMiddle("anna_complete", 9), "ann...ete");
  const std::string wide = "\u5c71\u7530\u592a\u90ce\u5c71\u7530\u592a\u90ce";
  EXPECT_EQ(columnsOf(wide), 16u);
  for (std::size_t columns = 0; columns < 20; ++columns)
    EXPECT_LE(columnsOf(cutInMiddle(wide, columns)), columns);
}

TEST(Markup, EscapesEverythingButMarkup) {
  const report::Markup inside = report::markup("<b>{}</b>", "<&>\"'");
  EXPECT_EQ(inside.html, "<b>&lt;&amp;&gt;&quot;&#39;</b>");
  EXPECT_EQ(report::markup("<p>{} {:.1f} {}</p>", inside, 0.25, 3).html,
            "<p>" + inside.html + " 0.2 3</p>");
}

TEST(EscapedUrl, IsARelativePathWhateverIsInIt) {
  EXPECT_EQ(report::escapedUrl("submissions/a b/x.html"), "./submissions/a%20b/x.html");
  EXPECT_EQ(report::escapedUrl("javascript:x?y#z"), "./javascript%3Ax%3Fy%23z");
  EXPECT_EQ(report::escapedUrl("\xc3\xab\"<"), "./%C3%AB%22%3C");
}

TEST(ClassTable, FitsIntoAHundredColumns) {
  test::SampleClass c = test::sampleClass();
  c.records[1].name = std::string(300, 'x');
  c.records[2].name = "\u5c71\u7530\u592a\u90ce\u5c71\u7530\u592a\u90ce\u5c71\u7530\u592a\u90ce";
  for (rubric::Marks& marks : c.marks)
    for (const int part : {7, 8}) marks.parts.push_back({part, "", 12.25, 20.0, {}});
  const std::string table = classTable(c.graded(), false);
  for (const std::string& line : linesOf(table)) EXPECT_LE(columnsOf(line), 100u) << line;
  EXPECT_NE(table.find("xxx...xxx"), std::string::npos) << table;
}

TEST(ClassTable, SaysWhatIsWrongInARowForEachSubmission) {
  const test::SampleClass c = test::sampleClass();
  const std::string table = classTable(c.graded(), false);
  const std::vector<std::string> lines = linesOf(table);
  const auto lineOf = [&](const std::string& name) {
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.starts_with(name);
    });
    return found == lines.end() ? std::string() : *found;
  };
  EXPECT_NE(lineOf("anna_complete").find(" 70.5"), std::string::npos) << table;
  EXPECT_NE(lineOf("dora_nearly").find("part 6 crashed"), std::string::npos) << table;
  EXPECT_NE(lineOf("emil_unlucky").find("internal error"), std::string::npos) << table;
  EXPECT_NE(table.find("parts 0 and 3 wrong"), std::string::npos) << table;
}

TEST(ClassTable, HasARowWithoutMarksForWhatWasLeftOut) {
  test::SampleClass c = test::sampleClass();
  const std::vector<std::string> before = linesOf(classTable(c.graded(), false));
  c.add(test::leftOutRecord("fay"));
  const std::vector<std::string> lines = linesOf(classTable(c.graded(), false));
  ASSERT_EQ(lines.size(), before.size() + 1);
  const std::string& row = lines[lines.size() - 2];
  EXPECT_TRUE(row.starts_with("fay ")) << row;
  EXPECT_NE(row.find("not graded"), std::string::npos) << row;
  EXPECT_EQ(row.find('0'), std::string::npos) << row;
  EXPECT_EQ(lines.back(), before.back()) << "the means";
}

TEST(ClassTable, HasNoMeanOfNoMarks) {
  test::SampleClass c;
  c.add(test::leftOutRecord("fay"));
  c.add(test::leftOutRecord("gil"));
  const std::vector<std::string> lines = linesOf(classTable(c.graded(), false));
  EXPECT_TRUE(lines.back().starts_with("mean ")) << lines.back();
  EXPECT_EQ(lines.back().find('0'), std::string::npos) << lines.back();
}

TEST(ClassTable, SpeaksOfSeveralPartsInThePlural) {
  test::SampleClass c = test::sampleClass();
  for (const std::size_t place : {3u, 4u})
    c.records[0].parts.at(place).verdict = record::Verdict::kDoesNotCompile;
  EXPECT_NE(classTable(c.graded(), false).find("parts 3 and 4 do not compile"), std::string::npos);
}

TEST(ClassTable, HasNoWordsForPartsThatDoNotCount) {
  test::SampleClass c = test::sampleClass();
  for (const std::size_t place : {2u, 3u})
    c.records[0].parts.at(place).verdict = record::Verdict::kWrong;
  for (rubric::Marks& marks : c.marks) marks.parts = {marks.parts.at(3)};
  const std::string table = classTable(c.graded(), false);
  EXPECT_NE(table.find("part 3 wrong"), std::string::npos) << table;
  for (const char* words : {"part 2", "parts", "whole"})
    EXPECT_EQ(table.find(words), std::string::npos) << words << "\n" << table;
}

TEST(ClassTable, NamesAPartThatIsRightButHasNoPicture) {
  test::SampleClass c = test::sampleClass();
  for (const std::size_t place : {2u, 5u})
    c.records[0].parts.at(place).pictures.at(0).failure = "It printed too much.";
  EXPECT_NE(classTable(c.graded(), false).find("parts 2 and 5 without a picture"),
            std::string::npos);
}

TEST(ClassTable, TellsAMissingFileFromAStub) {
  test::SampleClass c = test::sampleClass();
  for (const std::size_t place : {1u, 2u})
    c.records[0].parts.at(place).verdict = record::Verdict::kNotWritten;
  c.records[0].parts.at(2).functions.clear();
  const std::string table = classTable(c.graded(), false);
  EXPECT_NE(table.find("part 1 not written"), std::string::npos) << table;
  EXPECT_NE(table.find("part 2 missing"), std::string::npos) << table;
}

TEST(ClassTable, HasColourOnlyIfAsked) {
  test::SampleClass c = test::sampleClass();
  for (record::SubmissionRecord& record : c.records) record = test::withHostileTexts(record);
  EXPECT_EQ(classTable(c.graded(), false).find('\033'), std::string::npos);
  EXPECT_NE(classTable(c.graded(), true).find("\033[32m"), std::string::npos);
}

TEST(ClassTable, IsClean) {
  test::SampleClass c = test::sampleClass();
  for (record::SubmissionRecord& record : c.records) record = test::withHostileTexts(record);
  const std::string table = classTable(c.graded(), false);
  EXPECT_EQ(table, cleanText(table));
}

TEST(ClassTable, OfNobodySaysSo) { EXPECT_EQ(classTable({}, true), "No submissions.\n"); }

}  // namespace

}  // namespace pathmark
