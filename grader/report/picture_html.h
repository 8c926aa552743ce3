// A picture beside its reference, with what was measured of it.
#pragma once

#include "record/record.h"
#include "report/graded.h"
#include "report/html_text.h"

namespace pathmark::report {

// Yours, the reference and the signed error; picture_slider.js puts them on top of each other.
// Below them numbers, p-values and convergence, as far as they are known.
Markup pictureHtml(const record::PictureRecord& picture, const PictureSource& source);

// "2.1 % (1.9 to 2.3 %)".
std::string percentText(const record::Estimate& estimate);

}  // namespace pathmark::report
