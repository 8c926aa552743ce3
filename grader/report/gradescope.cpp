#include "report/gradescope.h"

#include "report/clean_text.h"
#include "report/record_words.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace pathmark::report {

namespace {

using Json = nlohmann::ordered_json;
using record::FunctionRecord;
using record::PartRecord;
using record::SubmissionRecord;
using record::Verdict;

constexpr std::size_t kLongestOutput = 8000;

// Without the last digits of sums, which are nobody's points.
double rounded(double points) { return std::round(1e6 * points) / 1e6; }

std::string foundIn(const FunctionRecord& function) {
  std::string text;
  for (const record::CheckRecord& check : function.checks)
    if (check.verdict != Verdict::kOk || !check.remark.empty())
      text += fmt::format("\n{}", textOf(check));
  return text;
}

// What the compiler said belongs to every line of its part.
std::string outputOf(const SubmissionRecord& record, const rubric::PartMarks& part,
                     const rubric::MarkLine& line) {
  std::string text = line.reason.empty() ? "All points.\n" : line.reason + "\n";
  if (const FunctionRecord* function = functionOf(record, line)) text += foundIn(*function);
  for (const PartRecord& p : record.parts)
    if (p.part == part.part && !p.message.empty() && line.points < line.outOf)
      text += fmt::format("\n{}\n", p.message);
  return cutAfter(cleanText(text), kLongestOutput);
}

Json testOf(const SubmissionRecord& record, const rubric::PartMarks& part, std::size_t number) {
  const rubric::MarkLine& line = part.lines[number];
  // Out of nothing: rounding is no failure.
  const bool full = line.outOf == 0.0 || line.points >= line.outOf;
  return Json{{"name", cleanLine(fmt::format("{}: {}", part.title, line.what))},
              {"number", fmt::format("{}.{}", part.part, number + 1)},
              {"score", rounded(line.points)},
              {"max_score", line.outOf},
              {"status", full ? "passed" : "failed"},
              {"output", outputOf(record, part, line)},
              {"output_format", "text"},
              {"visibility", "visible"}};
}

std::string summary(const SubmissionRecord& record, const rubric::Marks& marks) {
  std::string text;
  if (record.internalError())
    text += fmt::format("This submission could not be graded; that is no fault of it. {}\n",
                        record.failure);
  if (!record.leftOut.empty())
    text += fmt::format("This submission was not graded, and has no marks. {}\n", record.leftOut);
  for (const std::string& sentence : record.collecting) text += sentence + "\n";
  if (record.leftOut.empty())
    for (const std::string& sentence : whatIsWrong(record, marks)) text += sentence + "\n";
  return cutAfter(cleanText(text), kLongestOutput);
}

}  // namespace

std::string gradescopeJson(const SubmissionRecord& record, const rubric::Marks& marks) {
  Json json{{"score", marks.points},
            {"execution_time", record.seconds},
            {"output", summary(record, marks)},
            {"output_format", "text"},
            {"visibility", "visible"},
            {"stdout_visibility", "hidden"},
            {"tests", Json::array()}};
  // Without a score Gradescope shows no mark, and 0 is one.
  if (!record.leftOut.empty()) json.erase("score");
  for (const rubric::PartMarks& part : marks.parts)
    for (std::size_t i = 0; i < part.lines.size(); ++i)
      json["tests"].push_back(testOf(record, part, i));
  json["extra_data"] = Json{{"submission", cleanLine(record.name)},
                            {"contents", record.contents},
                            {"seed", fmt::format("{}", record.seed)},
                            {"out_of", marks.outOf},
                            {"complete", record.hasMarks()},
                            {"grader", record.build.program},
                            {"compiler", record.build.compiler},
                            {"flags", record.build.flags},
                            {"instructions", record.build.instructions},
                            {"sandbox", record.build.sandbox}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace pathmark::report
