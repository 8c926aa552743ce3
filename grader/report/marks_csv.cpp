#include "report/marks_csv.h"

#include "report/class_numbers.h"
#include "report/clean_text.h"
#include "report/record_words.h"
#include "report/to_look_at.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace pathmark::report {

namespace {

// Spreadsheets look past spaces and quotes, and take full-width signs for the same.
bool looksLikeFormula(std::string_view text) {
  constexpr std::array<std::string_view, 8> kBeginnings{"=",      "+",      "-",      "@",
                                                        "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"};
  text.remove_prefix(std::min(text.find_first_not_of(" \""), text.size()));
  return std::any_of(kBeginnings.begin(), kBeginnings.end(),
                     [&](std::string_view beginning) { return text.starts_with(beginning); });
}

std::string lineOf(const std::vector<std::string>& cells) {
  return fmt::format("{}\r\n", fmt::join(cells, ","));
}

std::string namesLine(const std::vector<ClassPart>& parts) {
  std::vector<std::string> cells{"name", "total", "out of"};
  for (const ClassPart& part : parts)
    for (const char* what : {"", " out of", " verdict"})
      cells.push_back(csvCell(partName(part.part) + what));
  cells.insert(cells.end(), {"seed", "remarks", "submission"});
  return lineOf(cells);
}

// `same`: which others have the same files.
std::string remarksOf(const Graded& graded, const std::string& same) {
  std::vector<std::string> remarks;
  if (graded.record->internalError()) remarks.push_back(graded.record->failure);
  if (!graded.record->leftOut.empty())
    remarks.push_back(fmt::format("No marks: {}", graded.record->leftOut));
  if (!same.empty()) remarks.push_back(same);
  for (std::string& sentence : reviewOf(graded)) remarks.push_back(std::move(sentence));
  const auto isSaid = [&](const std::string& sentence) {
    return std::any_of(remarks.begin(), remarks.end(), [&](const std::string& remark) {
      return remark.find(sentence) != std::string::npos;
    });
  };
  for (const std::string& sentence : graded.record->collecting)
    if (!isSaid(sentence)) remarks.push_back(sentence);
  return fmt::format("{}", fmt::join(remarks, " "));
}

std::string submissionLine(const Graded& graded, const std::vector<ClassPart>& parts, double outOf,
                           const std::string& same) {
  const bool complete = graded.record->hasMarks();
  const auto number = [&](double points) { return complete ? pointsText(points) : std::string(); };
  std::vector<std::string> cells{csvCell(graded.record->name), number(graded.marks->points),
                                 pointsText(complete ? graded.marks->outOf : outOf)};
  for (const ClassPart& part : parts) {
    const rubric::PartMarks* marks = marksOf(graded, part.part);
    const std::optional<record::Verdict> verdict = verdictOfPart(*graded.record, part.part);
    cells.push_back(marks ? number(marks->points) : "");
    cells.push_back(pointsText(marks ? marks->outOf : part.outOf));
    cells.push_back(verdict ? csvCell(nameOf(*verdict)) : "");
  }
  cells.push_back(fmt::format("{}", graded.record->seed));
  cells.push_back(csvCell(remarksOf(graded, same)));
  cells.push_back(csvCell(submissionName(*graded.record)));
  return lineOf(cells);
}

}  // namespace

std::string csvCell(std::string_view text) {
  // Tabs and carriage returns at the beginning would do as well as an equals sign: clean text in
  // one line has neither.
  std::string cell = cleanLine(text);
  if (looksLikeFormula(cell)) cell.insert(0, 1, '\'');
  if (cell.find_first_of(",\"\r\n'") == std::string::npos && !cell.starts_with(' ')) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string marksCsv(GradedClass graded) {
  const std::vector<ClassPart> parts = partsOf(graded);
  std::string csv = namesLine(parts);
  const std::vector<std::string> same = sameFiles(graded);
  for (std::size_t i = 0; i < graded.size(); ++i)
    csv += submissionLine(graded[i], parts, largestTotal(graded), same[i]);
  return csv;
}

}  // namespace pathmark::report
