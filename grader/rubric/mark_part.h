// The lines of one part. Each function adds to `toReview` what a person should look at, and returns
// no lines where nothing was graded.
#pragma once

#include "rubric/rubric.h"

#include <string>
#include <vector>

namespace pathmark::rubric {

// `part` is one of the record's.
std::vector<MarkLine> markPart(const record::SubmissionRecord& record,
                               const record::PartRecord& part, const PartRubric& worth,
                               const Rubric& rubric, std::vector<std::string>& toReview);

// Part 7: one scene that is valid, says what it shows and can be rendered earns all points.
std::vector<MarkLine> markScenes(const record::SubmissionRecord& record, const PartRubric& worth,
                                 const Rubric& rubric, std::vector<std::string>& toReview);

// The pictures of all parts together.
std::vector<MarkLine> markWhole(const record::SubmissionRecord& record, const PartRubric& worth,
                                const Rubric& rubric, std::vector<std::string>& toReview);

}  // namespace pathmark::rubric
