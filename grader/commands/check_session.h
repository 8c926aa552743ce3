// CheckSession: one check after another of the same coursework, each of what has changed since.
#pragma once

#include "checks/runner.h"

#include <string>
#include <vector>

namespace pathmark {

class CheckSession {
 public:
  CheckSession(checks::Selection selection, checks::RunOptions options);

  // The parts that run() would check: those that differ from what the results are of, or that have
  // none, because the last run was stopped. What has changed since that run comes first: somebody
  // waits for it.
  std::vector<int> changedParts(const CourseworkBuild& build) const;

  // Checks the parts that have changed; then all pictures, if they were selected. Throws
  // std::system_error where the machine cannot do it.
  const checks::CourseworkResults& run(const CourseworkBuild& build,
                                       const checks::RunEvents& events);

  const checks::CourseworkResults& results() const { return results_; }

 private:
  checks::Selection selection_;
  checks::RunOptions options_;
  std::vector<std::string> madeOf_;   // what each part of results_ was compiled to
  std::vector<std::string> lastRun_;  // what each part was compiled to, stopped or not
  checks::CourseworkResults results_;
};

}  // namespace pathmark
