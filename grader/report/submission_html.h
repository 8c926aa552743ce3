// report.html of a submission.
#pragma once

#include "record/record.h"
#include "report/graded.h"
#include "rubric/marks.h"

#include <string>

namespace pathmark::report {

// One file that needs no other. What only the teacher should see, such as marks.toReview, is left
// out: it is for students.
std::string submissionHtml(const record::SubmissionRecord& record, const rubric::Marks& marks,
                           const PictureSource& pictures);

}  // namespace pathmark::report
