#include "study/study_report.h"

#include "worker/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace pathmark::study {

namespace {

// All records of one subject.
struct Summary {
  int seeds = 0, failed = 0, found = 0, undecided = 0;
  std::map<std::string, int> failedChecks, undecidedChecks;
  std::int64_t statistics = 0;
  double seconds = 0.0;
};

std::string sectionOf(const std::string& function) {
  for (const FunctionContract& f : contract())
    if (f.name == function) return std::string(f.section);
  return {};
}

// Whether one of the failed checks is of the function that has the mistake. Functions of a part may
// rely on each other, so that another one of the part may be the first to show it.
bool foundIn(const StudyRecord& record, const std::string& section) {
  return std::any_of(record.failed.begin(), record.failed.end(),
                     [&](const std::string& id) { return id.starts_with(section + "/"); });
}

Summary summarise(const StudySubject& subject, const std::vector<StudyRecord>& records) {
  Summary s;
  const std::string section = subject.variant ? sectionOf(subject.variant->function) : "";
  for (const StudyRecord& record : records) {
    if (record.subject != subject.name) continue;
    ++s.seeds;
    s.failed += record.failed.empty() ? 0 : 1;
    s.undecided += record.undecided.empty() ? 0 : 1;
    s.found += !section.empty() && foundIn(record, section) ? 1 : 0;
    for (const std::string& id : record.failed) ++s.failedChecks[id];
    for (const std::string& id : record.undecided) ++s.undecidedChecks[id];
    s.statistics += record.statistics;
    s.seconds += record.seconds;
  }
  return s;
}

std::string listed(const std::map<std::string, int>& counts, int seeds) {
  std::vector<std::string> words;
  for (const auto& [id, count] : counts)
    words.push_back(count == seeds ? id : fmt::format("{} ({} of {})", id, count, seeds));
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

StudyReport reportStudy(const std::vector<StudySubject>& subjects,
                        const std::vector<StudyRecord>& records) {
  StudyReport report;
  int wrong = 0, correct = 0;
  for (const StudySubject& subject : subjects) {
    const Summary s = summarise(subject, records);
    if (s.seeds == 0) continue;
    const bool isWrong = subject.variant && subject.variant->wrong;
    const bool good = isWrong ? s.failed == s.seeds : s.failed == 0;
    report.asItMustBe = report.asItMustBe && good;
    (isWrong ? wrong : correct) += 1;
    std::string line = fmt::format("{:<9} {:<44} ", isWrong ? "wrong" : "correct", subject.name);
    if (isWrong)
      line += fmt::format("found in {} of {} seeds", s.failed, s.seeds);
    else
      line += fmt::format("fails in {} of {} seeds", s.failed, s.seeds);
    line += fmt::format("  {:.2f} s", s.seconds / s.seeds);
    if (!s.failedChecks.empty()) line += fmt::format("  {}", listed(s.failedChecks, s.seeds));
    if (isWrong && s.found < s.seeds)
      line += fmt::format("  (not in {})", subject.variant->function);
    if (!s.undecidedChecks.empty())
      line += fmt::format("  undecided: {}", listed(s.undecidedChecks, s.seeds));
    if (!subject.variant) line += fmt::format("  {} statistics a seed", s.statistics / s.seeds);
    report.text += line + (good ? "\n" : "   <-- must not be\n");
  }
  report.text += fmt::format("\n{} correct, {} wrong: {}\n", correct, wrong,
                             report.asItMustBe ? "all as they must be" : "NOT all as they must be");
  return report;
}

}  // namespace pathmark::study
