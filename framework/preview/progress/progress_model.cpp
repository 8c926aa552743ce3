#include "preview/progress/progress_model.h"

#include "host/display_path.h"
#include "host/where_to_look.h"

#include <fmt/format.h>

#include <algorithm>

namespace pathmark::preview {

namespace {

bool isWrong(Outcome outcome) { return outcome == Outcome::kFail || outcome == Outcome::kBroken; }

std::string failureOf(const PartContract& part, const CourseworkState& coursework,
                      const CheckReport* report) {
  const std::size_t place = placeOfPart(part.part);
  if (coursework.build && place < coursework.build->parts.size()) {
    const PartBuild& compiled = coursework.build->parts[place];
    if (compiled.missing) return std::string(compiled.problem());
    if (!compiled.compiled)
      return fmt::format("does not compile: {}", firstError(compiled.messages));
  }
  const bool current = report != nullptr && report->build == coursework.number;
  return current && place < report->failures.size() ? report->failures[place] : std::string();
}

FunctionRow rowOf(const FunctionContract& function, bool partFails,
                  const CourseworkState& coursework, const CheckReport* report) {
  FunctionRow row{function, Outcome::kUnknown, false, nullptr};
  if (partFails) return row;
  const FunctionVerdict* verdict = report != nullptr ? report->find(function.function) : nullptr;
  if (verdict != nullptr && verdict->outcome == Outcome::kUnknown) verdict = nullptr;
  const bool current = verdict != nullptr && verdict->build == coursework.number;
  if (!current && coursework.stubs.isUnwritten(function.function)) {
    row.outcome = Outcome::kNotWritten;
  } else if (verdict != nullptr && (current || verdict->outcome != Outcome::kNotWritten)) {
    row.outcome = verdict->outcome;
    row.older = !current;
    row.verdict = verdict;
  }
  return row;
}

// By what is known so far. What is wrong comes before what is not there yet.
void findNext(Progress& progress, const CourseworkState& coursework) {
  if (!coursework.build) return;
  for (const PartRow& part : progress.parts) {
    if (part.failure.empty()) continue;
    progress.next =
        fmt::format("mend {}, which {}.", displayPath(coursework.build->folder / part.part.file),
                    part.failure.substr(0, part.failure.find(':')));
    return;
  }
  const auto first = [&](auto matches) -> const FunctionRow* {
    for (const PartRow& part : progress.parts) {
      if (part.bonusNotBegun()) continue;
      for (const FunctionRow& row : part.functions)
        if (matches(row.outcome)) return &row;
    }
    return nullptr;
  };
  const FunctionRow* row = first(isWrong);
  if (row == nullptr) row = first([](Outcome o) { return o == Outcome::kNotWritten; });
  if (row == nullptr) return;
  progress.next = fmt::format("{} {}", isWrong(row->outcome) ? "mend" : "write",
                              placeOf(row->function, coursework.build->folder));
  progress.nextFunction = row->function.function;
}

// "3.3 lambertianBRDF::reflection: samples" of "3.3/samples".
std::string checkInWords(const std::string& id) {
  const std::size_t slash = id.find('/');
  for (const FunctionContract& f : contract())
    if (slash != std::string::npos && id.substr(0, slash) == f.section)
      return fmt::format("{} {}: {}", f.section, f.name, id.substr(slash + 1));
  return id;
}

// The compiler's quotation marks are not in every font.
std::string withPlainQuotes(const std::string& text) {
  constexpr std::string_view kLeft = "\u2018", kRight = "\u2019";
  std::string plain;
  for (std::size_t at = 0; at < text.size();) {
    const bool mark =
        text.compare(at, kLeft.size(), kLeft) == 0 || text.compare(at, kRight.size(), kRight) == 0;
    plain += mark ? '\'' : text[at];
    at += mark ? kLeft.size() : 1;
  }
  return plain;
}

}  // namespace

int PartRow::count(Outcome outcome) const {
  return static_cast<int>(
      std::count_if(functions.begin(), functions.end(),
                    [&](const FunctionRow& row) { return row.outcome == outcome; }));
}

bool PartRow::bonusNotBegun() const {
  return part.bonus && failure.empty() &&
         count(Outcome::kNotWritten) + count(Outcome::kUnknown) ==
             static_cast<int>(functions.size());
}

int Progress::count(Outcome outcome) const {
  int sum = 0;
  for (const PartRow& part : parts)
    if (!part.bonusNotBegun()) sum += part.count(outcome);
  return sum;
}

int Progress::functions() const {
  std::size_t sum = 0;
  for (const PartRow& part : parts)
    if (!part.bonusNotBegun()) sum += part.functions.size();
  return static_cast<int>(sum);
}

Progress progressOf(const CourseworkState& coursework, const CheckReport* report) {
  Progress progress;
  for (const PartContract& part : parts()) {
    PartRow row{part, failureOf(part, coursework, report), {}};
    for (const FunctionContract& f : contract())
      if (f.part == part.part)
        row.functions.push_back(rowOf(f, !row.failure.empty(), coursework, report));
    progress.parts.push_back(std::move(row));
  }
  if (report != nullptr && report->finished && report->build == coursework.number) {
    progress.next = report->next;
    progress.nextFunction = report->nextFunction;
    progress.status = report->headline;
    return progress;
  }
  findNext(progress, coursework);
  progress.checking = coursework.build != nullptr;
  if (!progress.checking || report == nullptr || report->build != coursework.number)
    return progress;
  progress.fraction = report->fraction;
  if (!report->current.empty())
    progress.status = fmt::format("Checking {}", checkInWords(report->current));
  return progress;
}

CheckReport withOlder(CheckReport newer, const CheckReport* older) {
  if (older == nullptr) return newer;
  for (FunctionVerdict& verdict : newer.functions) {
    const std::size_t place = placeOfPart(contractOf(verdict.function).part);
    const bool failed = place < newer.failures.size() && !newer.failures[place].empty();
    if (verdict.outcome != Outcome::kUnknown || failed) continue;
    if (const FunctionVerdict* before = older->find(verdict.function)) verdict = *before;
  }
  return newer;
}

const char* wordOf(Outcome outcome) {
  switch (outcome) {
    case Outcome::kPass:
      return "right";
    case Outcome::kFail:
      return "wrong";
    case Outcome::kUndecided:
      return "undecided";
    case Outcome::kBroken:
      return "broken";
    case Outcome::kNotWritten:
      return "not written yet";
    case Outcome::kBlocked:
      return "blocked";
    case Outcome::kUnknown:
      break;
  }
  return "not checked yet";
}

std::string firstError(const std::string& compilerWords) {
  const std::string messages = withPlainQuotes(compilerWords);
  const auto lineAt = [&](std::size_t at) {
    const std::size_t before = messages.rfind('\n', at);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    std::string line = messages.substr(begin, messages.find('\n', at) - begin);
    line.erase(0, line.find_first_not_of(" \t"));
    return line;
  };
  const std::size_t error = messages.find("error: ");
  if (error != std::string::npos) return lineAt(error);
  const std::size_t text = messages.find_first_not_of(" \t\n");
  return text == std::string::npos ? std::string() : lineAt(text);
}

}  // namespace pathmark::preview
