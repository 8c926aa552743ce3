#include "rubric/consequence.h"
#include "rubric/lost_file.h"
#include "rubric/mark_part.h"
#include "rubric/rubric.h"
#include "worker/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::rubric {

namespace {

using record::SubmissionRecord;

const record::PartRecord* find(const SubmissionRecord& record, int part) {
  const auto found = std::find_if(record.parts.begin(), record.parts.end(),
                                  [&](const record::PartRecord& p) { return p.part == part; });
  return found == record.parts.end() ? nullptr : &*found;
}

std::string titleOf(int part) {
  if (part == kWholePart) return "The whole as submitted";
  if (part == kScenesPart) return "Part 7: Your own scenes";
  const PartContract& named = partNumbered(part);
  return fmt::format("Part {}{}: {}", part, named.bonus ? ", bonus" : "", named.title);
}

// Rounded, with a line that makes the lines add up. Whoever has all points keeps all of them,
// whether they are a multiple of the step or not.
void addUp(PartMarks& marks, double outOf, double step) {
  marks.outOf = outOf;
  bool all = true;
  double sum = 0.0;
  for (const MarkLine& line : marks.lines) {
    all = all && line.points == line.outOf;
    sum += line.points;
  }
  marks.points = all ? outOf : sum;
  if (all || step == 0.0) return;
  marks.points = std::min(std::round(sum / step) * step, outOf);
  if (std::abs(marks.points - sum) > 1e-9)
    marks.lines.push_back({kRoundingLine, marks.points - sum, 0.0,
                           fmt::format("the points of a part are multiples of {:g}", step)});
}

}  // namespace

Marks markSubmission(const SubmissionRecord& record, const Rubric& rubric) {
  Marks marks;
  if (rubric.file != defaultRubric()) marks.rubric = rubric.file.string();
  if (record.internalError())
    marks.toReview.push_back(fmt::format(
        "The grader could not finish, which costs no points: {} Grade this submission again.",
        record.failure));
  if (record.outOfTime && record.hasMarks())
    marks.toReview.push_back(
        "The time for the whole submission was up before all of it was graded, which costs points: "
        "is it slow, or was the machine busy? Grade it again, with a larger --time-limit.");
  reviewLostFiles(record, marks.toReview);
  for (const PartRubric& worth : rubric.parts) {
    std::vector<MarkLine> lines;
    if (worth.part == kWholePart) {
      lines = markWhole(record, worth, rubric, marks.toReview);
    } else if (worth.part == kScenesPart) {
      lines = markScenes(record, worth, rubric, marks.toReview);
    } else if (const record::PartRecord* part = find(record, worth.part)) {
      lines = markPart(record, *part, worth, rubric, marks.toReview);
    }
    if (lines.empty()) continue;
    PartMarks part{worth.part, titleOf(worth.part), 0.0, 0.0, std::move(lines)};
    addUp(part, worth.points, rubric.step);
    marks.points += part.points;
    if (!worth.bonus) marks.outOf += part.outOf;
    marks.parts.push_back(std::move(part));
  }
  return marks;
}

}  // namespace pathmark::rubric
