#include "report/record_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::report {

using record::CheckRecord;
using record::FunctionRecord;
using record::PartRecord;
using record::SubmissionRecord;
using record::Verdict;

namespace {

std::optional<Verdict> bestVerdict(const std::vector<record::SceneRecord>& scenes) {
  std::optional<Verdict> best;
  for (const record::SceneRecord& scene : scenes)
    if (!best || worseThan(*best, scene.verdict)) best = scene.verdict;
  return best;
}

std::optional<Verdict> worstVerdict(const std::vector<CheckRecord>& checks) {
  const CheckRecord* worst = worstOf(checks);
  return worst != nullptr ? std::optional(worst->verdict) : std::nullopt;
}

// "part 4", "parts 2 and 3", "parts 2, 3 and 5".
std::string partNames(const std::vector<int>& parts) {
  if (parts.size() == 1) return partName(parts.front());
  std::string names = "parts ";
  for (std::size_t i = 0; i < parts.size(); ++i)
    names += fmt::format("{}{}", i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ", parts[i]);
  return names;
}

std::string_view wordsOf(Verdict verdict, bool several) {
  if (several && verdict == Verdict::kDoesNotCompile) return "do not compile";
  return nameOf(verdict);
}

}  // namespace

std::string whyNoMarks(const SubmissionRecord& record) {
  if (record.internalError()) return fmt::format("could not be graded: {}", record.failure);
  return record.leftOut.empty() ? std::string() : fmt::format("was not graded: {}", record.leftOut);
}

std::optional<Verdict> verdictOfPart(const SubmissionRecord& record, int part) {
  if (part == kScenesPart) return bestVerdict(record.scenes);
  if (part == kWhole) return worstVerdict(record.images);
  for (const PartRecord& p : record.parts)
    if (p.part == part) return p.verdict;
  return std::nullopt;
}

std::string partName(int part) {
  return part == kWhole ? std::string("whole") : fmt::format("part {}", part);
}

bool isFault(Verdict verdict) {
  return !worseThan(Verdict::kWrong, verdict) && verdict != Verdict::kInternalError;
}

std::vector<std::string> whatIsWrong(const SubmissionRecord& record) {
  if (record.internalError()) return {"internal error"};
  if (!record.leftOut.empty()) return {"not graded"};
  std::vector<std::string> sentences;
  std::vector<std::pair<Verdict, std::vector<int>>> groups;
  for (int part = 0; part <= kWhole; ++part) {
    const std::optional<Verdict> verdict = verdictOfPart(record, part);
    if (!verdict || *verdict == Verdict::kOk || *verdict == Verdict::kBlocked) continue;
    const auto same = [&](const auto& group) { return group.first == *verdict && part != kWhole; };
    const auto found = std::find_if(groups.begin(), groups.end(), same);
    if (found != groups.end())
      found->second.push_back(part);
    else
      groups.emplace_back(*verdict, std::vector<int>{part});
  }
  for (const auto& [verdict, parts] : groups)
    sentences.push_back(fmt::format("{} {}", partNames(parts), wordsOf(verdict, parts.size() > 1)));
  return sentences;
}

const CheckRecord* worstOf(const std::vector<CheckRecord>& checks) {
  const CheckRecord* worst = nullptr;
  for (const CheckRecord& check : checks)
    if (worst == nullptr || worseThan(check.verdict, worst->verdict)) worst = &check;
  return worst;
}

std::vector<Field> fieldsOf(const CheckRecord& check) {
  const bool blocked = check.verdict == Verdict::kBlocked;
  std::vector<Field> fields{{"where", check.where},
                            {"expected", check.expected},
                            {"got", check.got},
                            {"tolerance", check.tolerance},
                            {blocked ? "blocked by" : "likely cause", check.cause},
                            {"evidence", check.evidence},
                            {"note", check.remark},
                            {"read", check.read},
                            {"repeat", check.repeat}};
  std::erase_if(fields, [](const Field& field) { return field.value.empty(); });
  return fields;
}

std::string textOf(const CheckRecord& check) {
  std::string text = fmt::format("{}: {}\n{}\n", check.id, nameOf(check.verdict), check.statement);
  for (const Field& field : fieldsOf(check))
    text += fmt::format("{}: {}\n", field.name, field.value);
  return text;
}

const FunctionRecord* functionOf(const SubmissionRecord& record, const rubric::MarkLine& line) {
  for (const PartRecord& part : record.parts)
    for (const FunctionRecord& function : part.functions)
      if (line.what.starts_with(function.section + " ")) return &function;
  return nullptr;
}

std::string pointsText(double points) {
  if (!std::isfinite(points)) return "?";
  std::string text = fmt::format("{:.2f}", points);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string lineText(const rubric::MarkLine& line) {
  if (line.outOf == 0.0)
    return fmt::format("{}{}", line.points < 0.0 ? "\u2212" : "+",
                       pointsText(std::abs(line.points)));
  return fmt::format("{} / {}", pointsText(line.points), pointsText(line.outOf));
}

}  // namespace pathmark::report
