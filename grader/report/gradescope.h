// results.json of Gradescope (gradescope-autograders.readthedocs.io, "Autograder Specifications").
#pragma once

#include "record/record.h"
#include "rubric/marks.h"

#include <string>

namespace pathmark::report {

// A test for each line of the marks, with what was found as its text. What only the teacher should
// see, such as marks.toReview, is left out. There is no score where nothing was graded.
std::string gradescopeJson(const record::SubmissionRecord& record, const rubric::Marks& marks);

}  // namespace pathmark::report
