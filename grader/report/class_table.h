// The table of a class, for a terminal: a row for each submission.
#pragma once

#include "report/graded.h"

#include <string>

namespace pathmark::report {

// Not wider than 100 columns: long names are cut in the middle, and what is wrong goes on in the
// next line. Names are clean: they cannot move the cursor.
std::string classTable(GradedClass graded, bool colour);

}  // namespace pathmark::report
