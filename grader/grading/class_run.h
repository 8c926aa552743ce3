// Grading a class: all submissions, several at a time, each only once.
#pragma once

#include "grading/class_folder.h"
#include "grading/judge.h"
#include "submission/submission.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pathmark::grading {

struct ClassRunOptions {
  unsigned jobs = 1;     // submissions at the same time
  unsigned threads = 1;  // of each
  double secondsAtMost = 600.0;
};

struct ClassProgress {
  std::size_t done = 0, all = 0;
  double fraction = 0.0;
  double secondsLeft = 0.0;  // 0 where nothing is known yet
};

struct ClassEvents {
  // Several times a second, never from two threads at once; returns whether to go on.
  std::function<bool(const ClassProgress&)> onProgress;
  std::function<void(const record::SubmissionRecord&, bool known)> onDone;
};

// The names of the submissions' records, in their order. What was graded before, from the same
// files by the same program, is not graded again, unless it ran out of time, or had no sandbox and
// has one by now. Where a submission has another name by now, what is under its old one is removed.
// A submission that the grader or the machine fails at is tried twice, and its record says so. What
// is left out, or cannot be read, has a record that says why. Stops when it is told to, with the
// records that are there by then, and fewer names than submissions. Throws UsageError, before
// anything is graded, where a record belongs to another submission.
std::vector<std::string> gradeClass(const submission::FoundSubmissions& found,
                                    const ClassFolder& folder,
                                    std::shared_ptr<Confinement> confinement,
                                    const ClassRunOptions& options, const ClassEvents& events);

}  // namespace pathmark::grading
