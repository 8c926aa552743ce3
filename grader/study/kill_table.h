// The kill table: whether the check that a mistake names finds it, after how many calls, how far
// from right it is, and whether the diagnosis names it.
//
//   KillRow     one mistake
//   killTable   all of them
//   asText, asChapter   for a terminal, and as a chapter for instructors
#pragma once

#include "study/diagnosis_study.h"
#include "study/study.h"

#include <map>
#include <string>
#include <vector>

namespace pathmark::study {

struct KillRow {
  Variant variant;
  int seeds = 0, found = 0;             // under how many of the seeds a check failed
  int byItsCheck = 0;                   // and that the one that must find it
  std::map<std::string, int> byOthers;  // where it did not: what failed first, with how many seeds
  std::uint64_t calls = 0;              // of its check, at most over the seeds
  double seconds = 0.0;                 // that it took, mean
  double distance = 0.0;                // from right, in a check's deltas, largest; 0: exact
  std::string farthest;                 // the check
  std::vector<NamedCase> named;         // by itself with other random numbers, then in disguise

  bool asItMustBe() const;
};

std::vector<KillRow> killTable(const std::vector<StudySubject>& subjects,
                               const std::vector<StudyRecord>& records,
                               const DiagnosisReport& diagnosis);

std::string asText(const std::vector<KillRow>& rows);

// `right`: what is said of the solutions and of those that are correct but different.
std::string asChapter(const std::vector<KillRow>& rows, const std::vector<StudySubject>& subjects,
                      const std::vector<StudyRecord>& records, const DiagnosisReport& diagnosis);

}  // namespace pathmark::study
