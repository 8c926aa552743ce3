#include "report/terminal.h"

#include "checks/all_checks.h"
#include "host/display_path.h"
#include "host/shell_word.h"
#include "host/where_to_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace pathmark::report {

namespace {

using checks::CheckResult;
using checks::CourseworkResults;
using checks::Finding;
using checks::FunctionResult;
using checks::PartResult;
using checks::Status;

constexpr std::size_t kColumns = 100, kIndent = 15;

struct Word {
  const char* text;
  const char* colour;
};

Word wordOf(Status status) {
  switch (status) {
    case Status::kPass:
      return {"ok", "32"};
    case Status::kFail:
      return {"WRONG", "31;1"};
    case Status::kUndecided:
      return {"undecided", "33"};
    case Status::kBroken:
      return {"BROKEN", "31;1"};
    case Status::kNotWritten:
      return {"not written", "2"};
    case Status::kBlocked:
      break;
  }
  return {"blocked", "2"};
}

// Padded before it is coloured, so that columns stay in line.
std::string statusColumn(Status status, const Style& style) {
  const Word word = wordOf(status);
  const std::string padded = fmt::format("{:<11}", word.text);
  return style.colour ? fmt::format("\033[{}m{}\033[0m", word.colour, padded) : padded;
}

void addField(std::string& text, std::string_view name, std::string_view value) {
  if (value.empty()) return;
  const std::size_t indent = kIndent + 11;
  text += fmt::format("{:{}}{:<11}{}\n", "", kIndent, name, wrapped(value, indent));
}

std::string details(const CheckResult& result, std::uint64_t seed, const Style& style) {
  std::string text = fmt::format("{:{}}{}\n", "", kIndent,
                                 wrapped(fmt::format("{}.", result.check->statement), kIndent));
  for (const Field& field : fieldsOf(result)) addField(text, field.name, field.value);
  // In one line, however long: a break in it would be copied.
  text += fmt::format("{:{}}{:<11}{}\n", "", kIndent, "repeat",
                      repeatCommand(result, seed, style.with));
  return text;
}

std::string partOf(const FunctionContract& f) { return handoutOf(partNumbered(f.part)); }

// Of the checks of a function the worst tells enough: the others usually follow from it.
const CheckResult* worstOf(const FunctionResult& f) {
  const CheckResult* worst = nullptr;
  for (const CheckResult& r : f.checks)
    if (!worst || severity(r.finding.status) > severity(worst->finding.status)) worst = &r;
  return worst;
}

std::string functionLine(const FunctionResult& f, std::uint64_t seed, const Style& style) {
  std::string text = fmt::format("  {} {}  {}", statusColumn(f.status, style), f.function.section,
                                 f.function.name);
  const CheckResult* worst = worstOf(f);
  if (!worst || f.status == Status::kPass || f.status == Status::kNotWritten) {
    text += "\n";
    for (const CheckResult& r : f.checks)
      if (!r.finding.remark.empty()) addField(text, "note", r.finding.remark);
    return text;
  }
  if (f.status == Status::kBlocked) return text + fmt::format("  {}\n", blockedWords(f));
  return text + "\n" + details(*worst, seed, style);
}

struct Counts {
  int right = 0, wrong = 0, unwritten = 0, other = 0, all = 0;
};

Counts count(const CourseworkResults& results) {
  Counts counts;
  for (const PartResult& part : results.parts) {
    if (isBonusNotBegun(part)) continue;
    if (!part.failure.empty()) {
      for (const FunctionContract& f : contract()) counts.all += f.part == part.part.part ? 1 : 0;
      continue;
    }
    for (const FunctionResult& f : part.functions) {
      ++counts.all;
      if (f.status == Status::kPass)
        ++counts.right;
      else if (f.status == Status::kFail || f.status == Status::kBroken)
        ++counts.wrong;
      else if (f.status == Status::kNotWritten)
        ++counts.unwritten;
      else
        ++counts.other;
    }
  }
  return counts;
}

bool isWrongPicture(const CheckResult& picture) {
  return picture.finding.status == Status::kFail || picture.finding.status == Status::kBroken;
}

// "5 of 9 pictures are wrong"; empty where none is.
std::string wrongPictures(const CourseworkResults& results) {
  const auto wrong = std::count_if(results.images.begin(), results.images.end(), isWrongPicture);
  if (wrong == 0) return {};
  return fmt::format("{} of {} pictures {} wrong", wrong, results.images.size(),
                     wrong == 1 ? "is" : "are");
}

// A picture names no function: all that is known is where the parts agree with their own checks.
std::string whatIsNextOfPictures(const CourseworkResults& results) {
  const auto wrong = std::find_if(results.images.begin(), results.images.end(), isWrongPicture);
  if (wrong == results.images.end()) return {};
  const std::string_view why = count(results).all > 0
                                   ? "the parts agree with their own checks, but not together"
                                   : "./pathmark check says whether the parts are right one by one";
  return fmt::format(
      "look into {}, the first picture that is wrong: {}. ./pathmark preview shows the picture, "
      "./pathmark compare how one differs from its reference.",
      idOf(*wrong->check), why);
}

}  // namespace

std::string wrapped(std::string_view words, std::size_t indent) {
  std::string result;
  std::size_t column = indent;
  while (!words.empty()) {
    const std::size_t space = words.find_first_of(" \n");
    const std::string_view word = words.substr(0, space);
    if (column > indent && column + word.size() + 1 > kColumns) {
      result.append("\n").append(indent, ' ');
      column = indent;
    } else if (column > indent) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
    if (space == std::string_view::npos) break;
    if (words[space] == '\n') {
      result.append("\n").append(indent, ' ');
      column = indent;
    }
    words.remove_prefix(space + 1);
  }
  return result;
}

// What is wrong comes before what is not there yet.
const FunctionResult* nextFunction(const CourseworkResults& results) {
  const auto first = [&](auto matches) -> const FunctionResult* {
    for (const PartResult& part : results.parts) {
      if (isBonusNotBegun(part) && results.parts.size() > 1) continue;
      for (const FunctionResult& f : part.functions)
        if (matches(f.status)) return &f;
    }
    return nullptr;
  };
  const FunctionResult* wrong =
      first([](Status s) { return s == Status::kFail || s == Status::kBroken; });
  return wrong != nullptr ? wrong : first([](Status s) { return s == Status::kNotWritten; });
}

std::string standing(const CourseworkResults& results, const std::filesystem::path& folder) {
  const Counts counts = count(results);
  const std::string pictures = wrongPictures(results);
  const std::string ending = fmt::format(" (seed {}, {:.1f} s).", results.seed, results.seconds);
  if (counts.all == 0 && !pictures.empty())
    return fmt::format("{}: {}{}", displayPath(folder), pictures, ending);
  std::string text = fmt::format("{}: {} of {} functions are right", displayPath(folder),
                                 counts.right, counts.all);
  if (counts.wrong > 0) text += fmt::format(", {} wrong", counts.wrong);
  if (counts.unwritten > 0) text += fmt::format(", {} not written", counts.unwritten);
  if (counts.other > 0) text += fmt::format(", {} blocked or undecided", counts.other);
  if (!pictures.empty()) text += fmt::format(", but {}", pictures);
  return text + ending;
}

std::string whatIsNext(const CourseworkResults& results, const std::filesystem::path& folder) {
  for (const PartResult& part : results.parts)
    if (!part.failure.empty())
      return fmt::format("mend {}, which {}.", displayPath(folder / part.part.file),
                         part.failure.substr(0, part.failure.find(':')));
  const FunctionResult* next = nextFunction(results);
  if (next == nullptr) return whatIsNextOfPictures(results);
  return fmt::format("{} {}", next->status == Status::kNotWritten ? "write" : "mend",
                     placeOf(next->function, folder));
}

std::string headline(const CourseworkResults& results, const std::filesystem::path& folder) {
  const auto failed = [](const PartResult& part) { return !part.failure.empty(); };
  if (count(results).all == 0 && wrongPictures(results).empty() &&
      std::none_of(results.parts.begin(), results.parts.end(), failed))
    return {};
  std::string text = standing(results, folder) + "\n";
  const std::string next = whatIsNext(results, folder);
  if (!next.empty()) text += fmt::format("Next: {}\n", next);
  return text;
}

std::string blockedWords(const FunctionResult& function) {
  const CheckResult* worst = worstOf(function);
  if (worst == nullptr) return {};
  const bool someRight = std::any_of(function.checks.begin(), function.checks.end(),
                                     [](const CheckResult& r) { return r.finding.passed(); });
  return fmt::format("{}by {}", someRight ? "right so far; the rest " : "", worst->finding.cause);
}

std::vector<Field> fieldsOf(const CheckResult& result) {
  const Finding& finding = result.finding;
  const FunctionContract& function = contractOf(result.check->function);
  const std::string read = result.check->whole
                               ? "handouts/README.md"
                               : fmt::format("{}, section {}", partOf(function), function.section);
  const std::string_view got = finding.status == Status::kBroken ? "broken" : "got";
  std::vector<Field> fields{{"where", finding.where},
                            {"expected", finding.expected},
                            {got, finding.got},
                            {"tolerance", finding.tolerance},
                            {"shown", shownWords(finding.status == Status::kUndecided,
                                                 finding.shown, result.check->delta)},
                            {"likely", finding.cause},
                            {"evidence", finding.evidence},
                            {"read", read}};
  std::erase_if(fields, [](const Field& field) { return field.value.empty(); });
  return fields;
}

std::string repeatCommand(const CheckResult& result, std::uint64_t seed, const std::string& with) {
  std::string command = fmt::format("./pathmark check {} --seed {}", idOf(*result.check), seed);
  if (with != "student") command += " --with " + shellWord(with);
  return command;
}

std::string functionLines(const CourseworkResults& results, const Style& style) {
  std::string text;
  for (const PartResult& part : results.parts) {
    if (part.functions.empty() && part.failure.empty()) continue;
    text += fmt::format("\nPart {}  {}", part.part.part, part.part.title);
    if (isBonusNotBegun(part)) {
      text += ": bonus, not written yet\n";
      continue;
    }
    text += part.part.bonus ? " (bonus)\n" : "\n";
    if (!part.failure.empty())
      text += fmt::format("  {} {} {}\n", statusColumn(Status::kBroken, style), part.part.file,
                          part.failure.substr(0, part.failure.find_last_not_of('\n') + 1));
    for (const FunctionResult& f : part.functions) text += functionLine(f, results.seed, style);
  }
  return text;
}

std::string imageLines(const CourseworkResults& results, const Style& style) {
  if (results.images.empty()) return {};
  std::string text = "\nPictures\n";
  const CheckResult& first = results.images.front();
  if (std::all_of(results.images.begin(), results.images.end(), [&](const CheckResult& r) {
        return r.finding.status == Status::kBlocked && r.finding.cause == first.finding.cause;
      }))
    return text +
           fmt::format("  {} by {}\n", statusColumn(Status::kBlocked, style), first.finding.cause);
  for (const CheckResult& r : results.images) {
    text += fmt::format("  {} {}", statusColumn(r.finding.status, style), r.check->name);
    if (r.finding.status == Status::kBlocked)
      text += fmt::format("  by {}\n", r.finding.cause);
    else if (!r.finding.passed())
      text.append("\n").append(details(r, results.seed, style));
    else
      text += fmt::format(": {}\n", r.check->statement);
    // What is not judged, but said.
    if (r.finding.passed()) addField(text, "got", r.finding.got);
    addField(text, "note", r.finding.remark);
  }
  return text;
}

std::string listOfChecks(const checks::Selection& selection) {
  std::string text;
  const auto add = [&](const checks::Check& check) {
    if (!selection.selects(check)) return;
    const std::string finds =
        check.delta > 0.0 ? fmt::format("finds {:g} %", 100.0 * check.delta) : "exact";
    text += fmt::format("{:<26} {:<12} {}\n", idOf(check), finds, wrapped(check.statement, 40));
  };
  for (const int part : selection.parts)
    for (const checks::Check& check : checks::checksOfPart(part)) add(check);
  for (const checks::Check& check : checks::imageChecks()) add(check);
  return text;
}

std::string sceneLines(const CourseworkResults& results, const Style& style) {
  if (results.scenes.empty()) return {};
  std::string text = "\nPart 7  Your own scenes\n";
  for (const checks::SceneFinding& scene : results.scenes) {
    text += fmt::format("  {} {}", statusColumn(scene.status, style), displayPath(scene.file));
    if (scene.status == Status::kBlocked) {
      text += fmt::format("  by {}\n", scene.message);
      continue;
    }
    text += "\n";
    addField(text, scene.status == Status::kNotWritten ? "to do" : "wrong", scene.message);
    addField(text, "noise", scene.noise);
  }
  return text;
}

}  // namespace pathmark::report
