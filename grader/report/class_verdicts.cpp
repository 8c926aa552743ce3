#include "report/class_verdicts.h"

#include "report/page_html.h"
#include "report/record_words.h"

#include <algorithm>

namespace pathmark::report {

namespace {

using record::FunctionRecord;
using record::PartRecord;
using record::Verdict;

// All functions that any submission has, so that those of a part that does not compile are known.
std::map<std::string, FunctionCount> emptyCounts(GradedClass graded) {
  std::map<std::string, FunctionCount> counts;
  for (const Graded& g : graded)
    for (const PartRecord& part : g.record->parts)
      for (const FunctionRecord& function : part.functions)
        counts[function.section] = {function.section, function.name, {}};
  return counts;
}

void countPart(const PartRecord& part, std::map<std::string, FunctionCount>& counts) {
  for (const FunctionRecord& function : part.functions)
    ++counts[function.section].verdicts[function.verdict];
  if (!part.functions.empty()) return;
  const std::string prefix = fmt::format("{}.", part.part);
  for (auto& [section, count] : counts)
    if (section.starts_with(prefix)) ++count.verdicts[part.verdict];
}

// Verdicts side by side, each as wide as its share of the class.
Markup barOf(const FunctionCount& count, std::size_t submissions) {
  Markup pieces;
  double left = 0.0;
  for (const auto& [verdict, number] : count.verdicts) {
    const double width = 100.0 * static_cast<double>(number) / static_cast<double>(submissions);
    pieces += markup("<rect class=\"fill-{}\" x=\"{:.1f}\" width=\"{:.1f}\" height=\"8\"/>",
                     kindOf(verdict), left, width);
    left += width;
  }
  return markup(
      "<svg class=\"bar\" viewBox=\"0 0 100 8\" preserveAspectRatio=\"none\" aria-hidden=\"true\">"
      "<rect class=\"bar-rest\" width=\"100\" height=\"8\"/>{}</svg>",
      pieces);
}

}  // namespace

std::size_t FunctionCount::notOk() const {
  std::size_t count = 0;
  for (const auto& [verdict, number] : verdicts)
    if (verdict != Verdict::kOk) count += number;
  return count;
}

std::vector<FunctionCount> functionCounts(GradedClass graded) {
  std::map<std::string, FunctionCount> counts = emptyCounts(graded);
  for (const Graded& g : graded)
    for (const PartRecord& part : g.record->parts) countPart(part, counts);
  std::vector<FunctionCount> list;
  for (auto& [section, count] : counts) list.push_back(std::move(count));
  std::stable_sort(list.begin(), list.end(), [](const FunctionCount& a, const FunctionCount& b) {
    return a.notOk() > b.notOk();
  });
  return list;
}

Markup functionCountsHtml(const std::vector<FunctionCount>& counts, std::size_t submissions) {
  Markup rows;
  for (const FunctionCount& count : counts) {
    if (count.notOk() == 0 || submissions == 0) continue;
    Markup words;
    for (const auto& [verdict, number] : count.verdicts)
      words += markup("<span class=\"count\">{} {}</span> ", number, verdictChip(verdict));
    rows += markup(
        "<tr><th scope=\"row\">{} <code>{}</code></th><td class=\"barcell\">{}</td><td>{}</td>"
        "</tr>\n",
        count.section, count.name, barOf(count, submissions), words);
  }
  if (rows.html.empty()) return {};
  return markup(
      "<section class=\"part\"><h2>What went wrong most often</h2>\n<div class=\"scroll\">"
      "<table class=\"counts\"><thead><tr><th scope=\"col\">function</th>"
      "<th scope=\"col\">share of the class</th><th scope=\"col\">submissions</th></tr></thead>\n"
      "<tbody>{}</tbody></table></div></section>\n",
      rows);
}

}  // namespace pathmark::report
