// What a study has shown, as tables.
#pragma once

#include "study/kill_table.h"
#include "study/study.h"

#include <string>
#include <vector>

namespace pathmark::study {

struct StudyReport {
  std::string text;
  bool asItMustBe = true;  // what is right always passed, what is wrong was always found
};

StudyReport reportStudy(const std::vector<StudySubject>& subjects,
                        const std::vector<StudyRecord>& records, const std::vector<KillRow>& wrong);

}  // namespace pathmark::study
