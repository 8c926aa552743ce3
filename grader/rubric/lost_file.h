// Files of parts that were handed in, and not taken: under another name, too large, a link.
//
//   whatBecameOf      what was said of its file while it was collected
//   reviewLostFiles   sentences for a person about each part that has none for such a reason
#pragma once

#include "record/record.h"

#include <string>
#include <vector>

namespace pathmark::rubric {

// Sentences of `collecting`: "part5_path.cpp was refused: it is larger than 1 MiB." Empty where
// nothing like it was handed in.
std::string whatBecameOf(const record::SubmissionRecord& record, int part);

void reviewLostFiles(const record::SubmissionRecord& record, std::vector<std::string>& toReview);

}  // namespace pathmark::rubric
