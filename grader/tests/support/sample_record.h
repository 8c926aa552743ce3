// Records and marks for tests of reports, with values such as real ones have.
//
//   sampleRecord    a submission with every verdict and everything that a record can hold
//   sampleMarks     its marks; they add up
//   sampleClass     submissions of several kinds
//   leftOutRecord   what there is of one that could not be read
//   samplePicture   the bytes of any of their pictures
#pragma once

#include "report/graded.h"

#include <string>
#include <vector>

namespace pathmark::test {

record::SubmissionRecord sampleRecord(const std::string& name);
rubric::Marks sampleMarks();

struct SampleClass {
  std::vector<record::SubmissionRecord> records;
  std::vector<rubric::Marks> marks;

  void add(record::SubmissionRecord record);  // without marks
  std::vector<report::Graded> graded() const;
};

record::SubmissionRecord leftOutRecord(const std::string& name);

// One that is complete, one of all verdicts, one of a crash, one that could not be graded.
SampleClass sampleClass();

std::string samplePicture(const std::string& file);

}  // namespace pathmark::test
