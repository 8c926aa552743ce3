#include "preview/samples/sample_verdict.h"

#include "preview/progress/progress_model.h"

#include <fmt/format.h>

namespace pathmark::preview {

namespace {

// The first check with the outcome of the function.
const CheckLine* lineBehind(const FunctionVerdict& verdict) {
  for (const CheckLine& line : verdict.checks)
    if (line.outcome == verdict.outcome) return &line;
  return nullptr;
}

std::string headlineOf(const FunctionVerdict& verdict) {
  const CheckLine* line = lineBehind(verdict);
  switch (verdict.outcome) {
    case Outcome::kPass:
      return fmt::format("Right, by {}.", verdict.checks.size() == 1
                                              ? "its check"
                                              : fmt::format("{} checks", verdict.checks.size()));
    case Outcome::kFail:
      return line == nullptr ? "Wrong."
                             : fmt::format("Wrong, by {}: {}.", line->id, line->statement);
    case Outcome::kBroken:
      return line == nullptr ? "Broken." : fmt::format("Broken, in {}.", line->id);
    case Outcome::kUndecided:
      return "Undecided: neither right nor wrong could be shown.";
    case Outcome::kNotWritten:
      return "Not written yet.";
    case Outcome::kBlocked:
      return fmt::format("Not checked: blocked {}.", verdict.blocker);
    default:
      return "Not checked yet.";
  }
}

}  // namespace

VerdictWords verdictOn(CourseworkFunction function, const CourseworkState& coursework,
                       const CheckReport* report) {
  const Progress progress = progressOf(coursework, report);
  const PartRow& part = progress.parts.at(placeOfPart(contractOf(function).part));
  if (!part.failure.empty()) return {Outcome::kUnknown, "Not checked: the part cannot be.", {}};
  for (const FunctionRow& row : part.functions) {
    if (row.function.function != function) continue;
    if (row.outcome == Outcome::kNotWritten) return {row.outcome, "Not written yet.", {}};
    if (row.verdict == nullptr || row.older)
      return {Outcome::kUnknown, progress.checking ? "Being checked ..." : "Not checked yet.", {}};
    const CheckLine* line = lineBehind(*row.verdict);
    return {row.outcome, headlineOf(*row.verdict),
            line == nullptr ? std::vector<CheckLine::Field>() : line->fields};
  }
  return {};
}

}  // namespace pathmark::preview
