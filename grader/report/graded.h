// A graded submission, as the reports of a class take it.
#pragma once

#include "record/record.h"
#include "rubric/marks.h"

#include <functional>
#include <span>
#include <string>

namespace pathmark::report {

// The bytes of a record's PNG; empty if it is not there.
using PictureSource = std::function<std::string(const std::string& file)>;

struct Graded {
  const record::SubmissionRecord* record = nullptr;
  const rubric::Marks* marks = nullptr;
  std::string folder;  // of the submission's reports, relative to those of the class
  PictureSource pictures;
};

using GradedClass = std::span<const Graded>;

}  // namespace pathmark::report
