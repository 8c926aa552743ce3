// A known mistake's picture beside the student's.
#pragma once

#include "record/record.h"
#include "report/graded.h"
#include "report/html_text.h"

#include <string>

namespace pathmark::report {

// Whether the student's picture is nearer to the mistake's than a quarter of its distance from the
// correct one.
bool looksAlike(const record::MistakePicture& mistake);

// Yours, the mistake's and the correct picture, small, below a sentence that says whether they look
// alike. No pictures where yours is not off by enough to be seen. `invalid` is that of your
// picture's record: what of it is no radiance.
Markup mistakeHtml(const record::MistakePicture& mistake, const std::string& invalid,
                   const PictureSource& source);

}  // namespace pathmark::report
