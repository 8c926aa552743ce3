#include "report/class_table.h"

#include "report/class_numbers.h"
#include "report/clean_text.h"
#include "report/record_words.h"

#include <fmt/format.h>

#include <algorithm>

namespace pathmark::report {

namespace {

constexpr std::size_t kWidth = 100, kShortestName = 12, kLongestName = 24, kWords = 24;
constexpr std::string_view kGap = "  ";

constexpr std::string_view kGreen = "32", kRed = "31", kYellow = "33", kDim = "2", kBold = "1";

struct Cell {
  std::string text;
  std::string_view colour{};
};

struct Row {
  Cell name;
  std::vector<Cell> numbers;
  std::vector<std::string> words;
  std::string_view wordsColour{};
};

std::string painted(const std::string& text, std::string_view code, bool colour) {
  return colour && !code.empty() ? fmt::format("\033[{}m{}\033[0m", code, text) : text;
}

std::string padding(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, columnsOf(text)), ' ');
}

std::string_view colourOf(double points, double outOf) {
  if (points >= outOf) return kGreen;
  return points > 0.0 ? kYellow : kRed;
}

Row rowOf(const Graded& graded, const std::vector<ClassPart>& parts) {
  Row row{.name = {cleanLine(graded.record->name)}, .numbers = {}, .words = {}};
  const bool complete = graded.record->hasMarks();
  for (const ClassPart& part : parts) {
    const rubric::PartMarks* marks = marksOf(graded, part.part);
    if (marks == nullptr || !complete)
      row.numbers.push_back({"-", kDim});
    else
      row.numbers.push_back({pointsText(marks->points), colourOf(marks->points, marks->outOf)});
  }
  row.numbers.push_back({complete ? pointsText(graded.marks->points) : "-", kBold});
  row.words = whatIsWrong(*graded.record, *graded.marks);
  row.wordsColour = complete ? kDim : kRed;
  return row;
}

Row heading(const std::vector<ClassPart>& parts) {
  Row row{.name = {"submission", kDim}, .numbers = {}, .words = {}};
  for (const ClassPart& part : parts)
    row.numbers.push_back(
        {part.part == kWhole ? std::string("all") : fmt::format("p{}", part.part), kDim});
  row.numbers.push_back({"total", kDim});
  return row;
}

Row maxima(GradedClass graded, const std::vector<ClassPart>& parts) {
  Row row{.name = {"out of", kDim}, .numbers = {}, .words = {}};
  for (const ClassPart& part : parts) row.numbers.push_back({pointsText(part.outOf), kDim});
  row.numbers.push_back({pointsText(largestTotal(graded)), kDim});
  return row;
}

Row means(GradedClass graded, const std::vector<ClassPart>& parts) {
  Row row{.name = {"mean", kDim}, .numbers = {}, .words = {}};
  const auto add = [&](const std::vector<double>& points) {
    row.numbers.push_back(
        {points.empty() ? std::string("-") : fmt::format("{:.1f}", meanOf(points)), kDim});
  };
  for (const ClassPart& part : parts) add(pointsOfPart(graded, part.part));
  add(totalsOf(graded));
  return row;
}

// One sentence, broken between words where it has to be.
void addSentence(std::vector<std::string>& lines, std::string_view sentence, std::size_t width) {
  const auto fits = [&](std::string_view words) {
    return lines.back().empty() || columnsOf(lines.back()) + 1 + columnsOf(words) <= width;
  };
  if (!fits(sentence)) lines.emplace_back();
  while (!sentence.empty()) {
    const std::string_view word = sentence.substr(0, sentence.find(' '));
    sentence.remove_prefix(std::min(word.size() + 1, sentence.size()));
    if (!fits(word)) lines.emplace_back();
    lines.back() += fmt::format("{}{}", lines.back().empty() ? "" : " ", word);
  }
}

// With commas between them; a new line begins with a sentence where that is possible.
std::vector<std::string> linesOf(const std::vector<std::string>& sentences, std::size_t width) {
  std::vector<std::string> lines{{}};
  for (const std::string& sentence : sentences)
    addSentence(lines, &sentence == &sentences.back() ? sentence : fmt::format("{},", sentence),
                width);
  return lines;
}

struct Widths {
  std::size_t name = 0, words = 0;
  std::vector<std::size_t> numbers;
};

// Numbers have what they need; names and words share the rest.
Widths widthsOf(const std::vector<Row>& rows) {
  Widths widths;
  std::size_t taken = 0, longestName = 0;
  widths.numbers.resize(rows.front().numbers.size());
  for (std::size_t i = 0; i < widths.numbers.size(); ++i) {
    for (const Row& row : rows)
      widths.numbers[i] = std::max(widths.numbers[i], row.numbers[i].text.size());
    taken += widths.numbers[i] + 1;
  }
  for (const Row& row : rows) longestName = std::max(longestName, columnsOf(row.name.text));
  taken += kGap.size();
  const std::size_t room =
      std::clamp(kWidth - std::min(kWidth, taken + kWords), kShortestName, kLongestName);
  widths.name = std::clamp(longestName, kShortestName, room);
  widths.words = kWidth - std::min(kWidth - kShortestName, taken + widths.name);
  return widths;
}

std::string lineOf(const Row& row, const Widths& widths, bool colour) {
  const std::string name = cutInMiddle(row.name.text, widths.name);
  std::string line = painted(name, row.name.colour, colour) + padding(name, widths.name);
  for (std::size_t i = 0; i < row.numbers.size(); ++i)
    line += fmt::format(" {}{}", padding(row.numbers[i].text, widths.numbers[i]),
                        painted(row.numbers[i].text, row.numbers[i].colour, colour));
  std::size_t indent = widths.name + kGap.size();
  for (const std::size_t width : widths.numbers) indent += width + 1;
  const std::vector<std::string> words = linesOf(row.words, widths.words);
  for (std::size_t i = 0; i < words.size() && !words[i].empty(); ++i)
    line += fmt::format("{}{}", i == 0 ? std::string(kGap) : fmt::format("\n{:{}}", "", indent),
                        painted(words[i], row.wordsColour, colour));
  return line + "\n";
}

}  // namespace

std::string classTable(GradedClass graded, bool colour) {
  if (graded.empty()) return "No submissions.\n";
  const std::vector<ClassPart> parts = partsOf(graded);
  std::vector<Row> rows{heading(parts), maxima(graded, parts)};
  for (const Graded& g : graded) rows.push_back(rowOf(g, parts));
  if (graded.size() > 1) rows.push_back(means(graded, parts));
  const Widths widths = widthsOf(rows);
  std::string table;
  for (const Row& row : rows) table += lineOf(row, widths, colour);
  return table;
}

}  // namespace pathmark::report
