#include "report/record_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace pathmark::report {

using record::CheckRecord;
using record::FunctionRecord;
using record::PartRecord;
using record::SubmissionRecord;
using record::Verdict;

namespace {

// Only where the whole was graded are there pictures of it, and scenes were looked for.
std::optional<Verdict> verdictOfScenes(const SubmissionRecord& record) {
  std::optional<Verdict> best;
  for (const record::SceneRecord& scene : record.scenes)
    if (!best || worseThan(*best, scene.verdict)) best = scene.verdict;
  if (best || record.pictures.empty() || !record.hasMarks()) return best;
  return record.outOfTime && record.images.empty() ? Verdict::kTimeLimit : Verdict::kNotWritten;
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

bool lostAPicture(const std::vector<record::PictureRecord>& pictures) {
  return std::any_of(pictures.begin(), pictures.end(),
                     [](const record::PictureRecord& picture) { return !picture.failure.empty(); });
}

bool lostAPicture(const SubmissionRecord& record, int part) {
  if (part == kWhole) return lostAPicture(record.pictures);
  return std::any_of(record.parts.begin(), record.parts.end(), [&](const PartRecord& p) {
    return p.part == part && lostAPicture(p.pictures);
  });
}

// What to say after the name of one part; empty if nothing is wrong with it itself.
std::string_view wordsOf(const SubmissionRecord& record, int part, Verdict verdict) {
  if (verdict == Verdict::kBlocked) return {};
  if (verdict == Verdict::kOk) return lostAPicture(record, part) ? "without a picture" : "";
  for (const PartRecord& p : record.parts)
    if (p.part == part && !p.hasFile()) return "missing";
  return nameOf(verdict);
}

std::string_view ofSeveral(std::string_view words) {
  return words == nameOf(Verdict::kDoesNotCompile) ? "do not compile" : words;
}

// Letters and digits of all scripts: what a submission's name keeps of that of its file.
std::string lettersOf(std::string_view name) {
  std::string letters;
  for (const char c : name)
    if (static_cast<unsigned char>(c) >= 0x80 || std::isalnum(static_cast<unsigned char>(c)) != 0)
      letters += c;
  return letters;
}

// Without the number that a second one of the same name has.
bool hasItsNameFrom(const std::string& name, const std::string& file) {
  const std::size_t end = name.find_last_not_of("0123456789");
  const bool numbered = end != std::string::npos && end + 1 < name.size() && name[end] == '-';
  return lettersOf(file).starts_with(lettersOf(numbered ? name.substr(0, end) : name));
}

}  // namespace

std::string whyNoMarks(const SubmissionRecord& record, bool several) {
  if (record.internalError()) return fmt::format("could not be graded: {}", record.failure);
  if (record.leftOut.empty()) return {};
  return fmt::format("{} not graded: {}", several ? "were" : "was", record.leftOut);
}

std::string endOfPath(const std::string& path) {
  const std::filesystem::path whole = path;
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

std::string submissionName(const SubmissionRecord& record) {
  std::filesystem::path source = record.source;
  if (!source.has_filename()) source = source.parent_path();
  const std::string file = endOfPath(record.source),
                    folder = source.parent_path().filename().string();
  return hasItsNameFrom(record.name, file) || !hasItsNameFrom(record.name, folder)
             ? file
             : fmt::format("{}/{}", folder, file);
}

std::optional<Verdict> verdictOfPart(const SubmissionRecord& record, int part) {
  if (part == kScenesPart) return verdictOfScenes(record);
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

bool isMarked(const rubric::Marks& marks, int part) {
  return std::any_of(marks.parts.begin(), marks.parts.end(),
                     [&](const rubric::PartMarks& marked) { return marked.part == part; });
}

std::vector<std::string> whatIsWrong(const SubmissionRecord& record, const rubric::Marks& marks) {
  if (record.internalError()) return {"internal error"};
  if (!record.leftOut.empty()) return {"not graded"};
  std::vector<std::string> sentences;
  std::vector<std::pair<std::string_view, std::vector<int>>> groups;
  for (int part = 0; part <= kWhole; ++part) {
    const std::optional<Verdict> verdict = verdictOfPart(record, part);
    if (!verdict || !isMarked(marks, part)) continue;
    const std::string_view words = wordsOf(record, part, *verdict);
    if (words.empty()) continue;
    const auto same = [&](const auto& group) { return group.first == words && part != kWhole; };
    const auto found = std::find_if(groups.begin(), groups.end(), same);
    if (found != groups.end())
      found->second.push_back(part);
    else
      groups.emplace_back(words, std::vector<int>{part});
  }
  sentences.reserve(sentences.size() + groups.size());
  for (const auto& [words, parts] : groups)
    sentences.push_back(
        fmt::format("{} {}", partNames(parts), parts.size() > 1 ? ofSeveral(words) : words));
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
  std::vector<Field> fields{
      {"where", check.where},
      {"expected", check.expected},
      {"got", check.got},
      {"tolerance", check.tolerance},
      {"shown", shownWords(check.verdict == Verdict::kUndecided, check.shown, check.delta)},
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
