#include "report/class_numbers.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace pathmark::report {

std::vector<ClassPart> partsOf(GradedClass graded) {
  std::map<int, ClassPart> parts;
  for (const Graded& g : graded)
    for (const rubric::PartMarks& marks : g.marks->parts) {
      ClassPart& part =
          parts.try_emplace(marks.part, ClassPart{marks.part, marks.title, 0.0}).first->second;
      part.outOf = std::max(part.outOf, marks.outOf);
    }
  std::vector<ClassPart> list;
  for (const auto& [number, part] : parts) list.push_back(part);
  return list;
}

const rubric::PartMarks* marksOf(const Graded& graded, int part) {
  for (const rubric::PartMarks& marks : graded.marks->parts)
    if (marks.part == part) return &marks;
  return nullptr;
}

double largestTotal(GradedClass graded) {
  double outOf = 0.0;
  for (const Graded& g : graded) outOf = std::max(outOf, g.marks->outOf);
  return outOf;
}

std::vector<double> totalsOf(GradedClass graded) {
  std::vector<double> totals;
  for (const Graded& g : graded)
    if (g.record->hasMarks()) totals.push_back(g.marks->points);
  return totals;
}

std::vector<double> pointsOfPart(GradedClass graded, int part) {
  std::vector<double> points;
  for (const Graded& g : graded)
    if (const rubric::PartMarks* marks = marksOf(g, part); marks && g.record->hasMarks())
      points.push_back(marks->points);
  return points;
}

double meanOf(const std::vector<double>& values) {
  if (values.empty()) return 0.0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace pathmark::report
