#include "study/study_report.h"

#include <fmt/format.h>

#include <map>

namespace pathmark::study {

namespace {

// All records of one subject.
struct Summary {
  int seeds = 0, failed = 0;
  std::map<std::string, int> failedChecks, undecidedChecks;
  std::int64_t statistics = 0;
  double seconds = 0.0;
};

Summary summarise(const StudySubject& subject, const std::vector<StudyRecord>& records) {
  Summary s;
  for (const StudyRecord& record : records) {
    if (record.subject != subject.name) continue;
    ++s.seeds;
    s.failed += record.failed.empty() ? 0 : 1;
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
                        const std::vector<StudyRecord>& records,
                        const std::vector<KillRow>& wrong) {
  StudyReport report;
  int correct = 0;
  for (const StudySubject& subject : subjects) {
    if (subject.variant && subject.variant->wrong) continue;
    const Summary s = summarise(subject, records);
    if (s.seeds == 0) continue;
    const bool good = s.failed == 0;
    report.asItMustBe = report.asItMustBe && good;
    ++correct;
    report.text += fmt::format("correct   {:<44} fails in {} of {} seeds  {:.2f} s", subject.name,
                               s.failed, s.seeds, s.seconds / s.seeds);
    if (!s.failedChecks.empty())
      report.text += fmt::format("  {}", listed(s.failedChecks, s.seeds));
    if (!s.undecidedChecks.empty())
      report.text += fmt::format("  undecided: {}", listed(s.undecidedChecks, s.seeds));
    if (!subject.variant)
      report.text += fmt::format("  {} statistics a seed", s.statistics / s.seeds);
    report.text += good ? "\n" : "   <-- must not be\n";
  }
  if (!wrong.empty()) report.text += fmt::format("\n{}", asText(wrong));
  for (const KillRow& row : wrong) report.asItMustBe = report.asItMustBe && row.asItMustBe();
  report.text += fmt::format("\n{} correct, {} wrong: {}\n", correct, wrong.size(),
                             report.asItMustBe ? "all as they must be" : "NOT all as they must be");
  return report;
}

}  // namespace pathmark::study
