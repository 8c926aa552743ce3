// CheckSession: one check after another of the same coursework, each of what has changed since.
#pragma once

#include "checks/runner.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace pathmark {

class CheckSession {
 public:
  CheckSession(std::filesystem::path folder, checks::Selection selection,
               checks::RunOptions options);

  // Compiles, and checks the parts that differ from those of the last run; then all pictures, if
  // any of them differs. Throws std::system_error where the machine cannot do it.
  const checks::CourseworkResults& run(const checks::RunEvents& events);

  const checks::CourseworkResults& results() const { return results_; }

 private:
  std::filesystem::path folder_;
  checks::Selection selection_;
  checks::RunOptions options_;
  std::vector<std::string> madeOf_;  // what each part of results_ was compiled to
  checks::CourseworkResults results_;
};

}  // namespace pathmark
