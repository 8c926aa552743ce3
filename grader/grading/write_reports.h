// writeReports: marks and reports of all records of a class, made from nothing else.
#pragma once

#include "grading/class_folder.h"
#include "record/record.h"
#include "rubric/marks.h"
#include "rubric/rubric.h"

#include <string>
#include <vector>

namespace pathmark::grading {

class ClassReports {
 public:
  ClassReports(std::vector<record::SubmissionRecord> records, std::vector<rubric::Marks> marks,
               std::vector<std::string> unreadable)
      : records_(std::move(records)),
        marks_(std::move(marks)),
        unreadable_(std::move(unreadable)) {}

  // For a terminal.
  std::string table(bool colour) const;

  const std::vector<record::SubmissionRecord>& records() const { return records_; }
  const std::vector<rubric::Marks>& marks() const { return marks_; }

  // Names of submissions whose records are damaged: they have no marks.
  const std::vector<std::string>& unreadable() const { return unreadable_; }

  // Whether one has no marks because of that, or because the grader or the machine failed at it.
  bool anyFailed() const;

 private:
  std::vector<record::SubmissionRecord> records_;
  std::vector<rubric::Marks> marks_;
  std::vector<std::string> unreadable_;
};

// Beside each record report.html, results.json and junit.xml; for the class report.html, marks.csv
// and junit.xml. Those that are `notYet` graded have rows without marks. Throws ImageError where a
// file cannot be written.
ClassReports writeReports(const ClassFolder& folder, const rubric::Rubric& rubric,
                          const std::vector<std::string>& notYet);

}  // namespace pathmark::grading
