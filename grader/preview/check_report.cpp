#include "preview/check_report.h"

#include "host/coursework_builder.h"
#include "host/display_path.h"
#include "report/terminal.h"

#include <fmt/format.h>

#include <algorithm>

namespace pathmark {

namespace {

using preview::CheckLine;
using preview::CheckReport;
using preview::FunctionVerdict;
using preview::Outcome;

Outcome outcomeOf(checks::Status status) {
  switch (status) {
    case checks::Status::kPass:
      return Outcome::kPass;
    case checks::Status::kFail:
      return Outcome::kFail;
    case checks::Status::kUndecided:
      return Outcome::kUndecided;
    case checks::Status::kBroken:
      return Outcome::kBroken;
    case checks::Status::kNotWritten:
      return Outcome::kNotWritten;
    case checks::Status::kBlocked:
      break;
  }
  return Outcome::kBlocked;
}

// As the command line takes it.
std::string wordFor(const std::filesystem::path& folder) {
  for (const char* own : {"student", "solutions"})
    if (folder == courseworkFolder(own)) return own;
  return displayPath(folder);
}

CheckLine lineOf(const checks::CheckResult& result, std::uint64_t seed, const std::string& with) {
  CheckLine line;
  line.id = idOf(*result.check);
  line.statement = result.check->statement;
  line.outcome = outcomeOf(result.finding.status);
  line.note = result.finding.remark;
  line.command = report::repeatCommand(result, seed, with);
  if (line.outcome == Outcome::kPass) return line;
  if (line.outcome == Outcome::kBlocked) {
    line.fields.push_back({"blocked", "by " + result.finding.cause});
  } else {
    for (const report::Field& field : report::fieldsOf(result))
      line.fields.push_back({std::string(field.name), field.value});
  }
  for (const CheckLine::Field& field : line.fields)
    line.found += fmt::format("{}{} {}", line.found.empty() ? "" : "\n", field.name, field.value);
  return line;
}

FunctionVerdict verdictOf(const checks::FunctionResult& result, std::uint64_t seed,
                          const std::string& with) {
  FunctionVerdict verdict;
  verdict.function = result.function.function;
  verdict.outcome = outcomeOf(result.status);
  if (result.status == checks::Status::kBlocked) verdict.blocker = report::blockedWords(result);
  for (const checks::CheckResult& r : result.checks)
    verdict.checks.push_back(lineOf(r, seed, with));
  return verdict;
}

}  // namespace

CheckReport reportOf(const checks::CourseworkResults& results, std::uint64_t build,
                     const std::filesystem::path& folder) {
  const std::string with = wordFor(folder);
  CheckReport report;
  report.build = build;
  for (const FunctionContract& f : contract()) {
    const checks::FunctionResult* result = results.find(f.function);
    if (result == nullptr) {
      report.functions.push_back({f.function, Outcome::kUnknown, {}, {}, 0});
      continue;
    }
    report.functions.push_back(verdictOf(*result, results.seed, with));
    report.functions.back().build = build;
  }
  report.failures.resize(parts().size());
  for (const checks::PartResult& part : results.parts)
    report.failures.at(placeOfPart(part.part.part)) = part.failure;
  return report;
}

CheckReport finishedReport(const checks::CourseworkResults& results, std::uint64_t build,
                           const std::filesystem::path& folder) {
  CheckReport report = reportOf(results, build, folder);
  report.finished = true;
  report.fraction = 1.0;
  report.headline = report::standing(results, folder);
  report.next = report::whatIsNext(results, folder);
  const bool allChecked = std::all_of(report.failures.begin(), report.failures.end(),
                                      [](const std::string& failure) { return failure.empty(); });
  if (const checks::FunctionResult* next = report::nextFunction(results); next && allChecked)
    report.nextFunction = next->function.function;
  return report;
}

}  // namespace pathmark
