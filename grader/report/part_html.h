// A part in the report of a submission: marks, what the compiler said, functions, samples,
// pictures. Parts 7 and 8 are the scenes and the whole as submitted.
#pragma once

#include "record/record.h"
#include "report/graded.h"
#include "report/html_text.h"
#include "rubric/marks.h"

#include <string>
#include <vector>

namespace pathmark::report {

// What there is of a part in the record and in the marks.
struct PartView {
  int part = 0;
  std::string title;  // "Part 3: The Lambertian BRDF"
  const record::PartRecord* record = nullptr;
  const rubric::PartMarks* marks = nullptr;
};

std::vector<PartView> partViews(const record::SubmissionRecord& record, const rubric::Marks& marks);

Markup partHtml(const PartView& view, const record::SubmissionRecord& record,
                const PictureSource& source);

// "8 of 15 points"; nothing without marks.
std::string pointsOutOf(const rubric::PartMarks* marks);

}  // namespace pathmark::report
