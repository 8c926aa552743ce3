#include "study/kill_table.h"

#include "worker/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::study {

namespace {

void note(const StudyRecord& record, KillRow& row) {
  ++row.seeds;
  row.seconds += record.checkSeconds;
  row.calls = std::max(row.calls, record.calls);
  if (record.failed.empty()) return;
  ++row.found;
  const auto its = std::find(record.failed.begin(), record.failed.end(), row.variant.check);
  if (its != record.failed.end())
    ++row.byItsCheck;
  else
    ++row.byOthers[record.failed.front()];
  if (record.seed == 1) {
    row.distance = record.distance;
    row.farthest = record.farthest;
  }
}

// "right", or "right 3 of 4" where it is also disguised.
std::string namedWords(const KillRow& row) {
  int all = 0, right = 0, wrong = 0;
  for (const NamedCase& c : row.named) {
    if (c.known == Named::kUnseen) continue;
    ++all;
    right += c.known == Named::kRight ? 1 : 0;
    wrong += c.known == Named::kWrong ? 1 : 0;
  }
  if (all == 0) return "-";
  std::string words = right == all ? fmt::format("right, {0} of {0}", all)
                                   : fmt::format("right, {} of {}", right, all);
  if (wrong > 0) words += fmt::format("; wrong, {}", wrong);
  return words;
}

// "0.7/plates", or "0.7/plates (18 of 20; 0.7/light, 2)" where others found it.
std::string checkWords(const KillRow& row) {
  if (row.byItsCheck == row.seeds) return row.variant.check;
  std::string words = fmt::format("{} ({} of {}", row.variant.check, row.byItsCheck, row.seeds);
  for (const auto& [id, count] : row.byOthers) words += fmt::format("; {}, {}", id, count);
  return words + ")";
}

std::string distanceWords(const KillRow& row) {
  if (row.distance == 0.0) return "exact";
  const std::string words = row.distance < 99.5 ? fmt::format("{:.1f}", row.distance)
                                                : fmt::format("{:.0f}", row.distance);
  return row.farthest == row.variant.check ? words : fmt::format("{} ({})", words, row.farthest);
}

}  // namespace

// A check that promises to find an error of delta is tried on twice that: nearer, it would also
// show where its promise just holds.
bool KillRow::asItMustBe() const {
  const bool clear = distance == 0.0 || distance >= 2.0;
  return seeds > 0 && byItsCheck == seeds && clear;
}

std::vector<KillRow> killTable(const std::vector<StudySubject>& subjects,
                               const std::vector<StudyRecord>& records,
                               const DiagnosisReport& diagnosis) {
  std::vector<KillRow> rows;
  for (const StudySubject& subject : subjects) {
    if (!subject.variant || !subject.variant->wrong) continue;
    KillRow row;
    row.variant = *subject.variant;
    for (const StudyRecord& record : records)
      if (record.subject == subject.name) note(record, row);
    if (row.seeds == 0) continue;
    row.seconds /= row.seeds;
    for (const auto* cases : {&diagnosis.single, &diagnosis.disguised})
      for (const NamedCase& c : *cases)
        if (c.mistake == subject.name) row.named.push_back(c);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string asText(const std::vector<KillRow>& rows) {
  std::string text = fmt::format("{:<44} {:<8} {:<32} {:>9} {:>8} {:>20}  {}\n", "mistake", "found",
                                 "its check", "calls", "ms", "deltas", "diagnosis");
  for (const KillRow& row : rows)
    text += fmt::format("{:<44} {:<8} {:<32} {:>9} {:>8.1f} {:>20}  {}{}\n", row.variant.name,
                        fmt::format("{}/{}", row.found, row.seeds), checkWords(row), row.calls,
                        1000.0 * row.seconds, distanceWords(row), namedWords(row),
                        row.asItMustBe() ? "" : "   <-- must not be");
  return text;
}

std::string asChapter(const std::vector<KillRow>& rows, const std::vector<StudySubject>& subjects,
                      const std::vector<StudyRecord>& records, const DiagnosisReport& diagnosis) {
  int seeds = 0;
  for (const KillRow& row : rows) seeds = std::max(seeds, row.seeds);
  std::string text = fmt::format(
      "# Known mistakes\n\n"
      "For instructors; not part of what students receive. `./pathmark study --seeds {1} --handout "
      "handouts/mistakes.md` makes\nthis chapter anew; its times are those of the machine on "
      "which that was done last.\n\n"
      "`grader/variants/wrong/` has {0} mistakes, each a small patch against the solutions, which "
      "names the check that must\nfind it. Under each of {1} seeds it does. No other part can fail "
      "with the mistake: a part is checked in a program\nthat has that part alone and stand-ins "
      "for the "
      "others, so the programs of the other parts are those of the\nsolutions, byte for byte, "
      "which pass.\n\n"
      "* **check**: the one that must find the mistake, and does, under each seed.\n"
      "* **calls**, **ms**: of that check: of the coursework's functions, and its time.\n"
      "* **deltas**: how far from right the mistake is, in the smallest errors that a check "
      "promises to find, under the\n  first seed; in the check that finds it farthest, which is "
      "named where it is another. *exact*: of a\n  check without statistics.\n"
      "* **named**: how often the diagnosis named the mistake: by itself with random numbers that "
      "are not those of\n  the catalogue, and in files that also differ from the solutions where "
      "they may.\n",
      rows.size(), seeds);
  for (const PartContract& part : parts()) {
    bool any = false;
    for (const KillRow& row : rows) {
      if (row.variant.part != part.part) continue;
      if (!any)
        text += fmt::format(
            "\n## Part {}: {}\n\n| mistake | function | check | calls | ms | deltas | named "
            "|\n|---|---|---|---:|---:|---:|---|\n",
            part.part, part.title);
      any = true;
      text += fmt::format("| `{}`: {} | `{}` | `{}` | {} | {:.1f} | {} | {} |\n", row.variant.name,
                          row.variant.what, row.variant.function, checkWords(row), row.calls,
                          1000.0 * row.seconds, distanceWords(row), namedWords(row));
    }
  }
  text += "\n## What is right, but different\n\n| different | seeds | failed |\n|---|---:|---:|\n";
  for (const StudySubject& subject : subjects) {
    if (subject.variant && subject.variant->wrong) continue;
    int all = 0, failed = 0;
    for (const StudyRecord& record : records) {
      if (record.subject != subject.name) continue;
      ++all;
      failed += record.failed.empty() ? 0 : 1;
    }
    text +=
        fmt::format("| {} | {} | {} |\n",
                    subject.variant ? fmt::format("`{}`: {}", subject.name, subject.variant->what)
                                    : "the solutions",
                    all, failed);
  }
  return text + "\n## How good the diagnosis is\n\n" + diagnosis.chapter();
}

}  // namespace pathmark::study
