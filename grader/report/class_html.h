// report.html of a class.
#pragma once

#include "report/graded.h"

#include <string>

namespace pathmark::report {

// One file, with links to the submissions' reports, FOLDER/report.html.
std::string classHtml(GradedClass graded);

}  // namespace pathmark::report
