// marks.csv: a row for each submission, for spreadsheets and course systems.
#pragma once

#include "report/graded.h"

#include <string>
#include <string_view>

namespace pathmark::report {

// A cell of text: clean, in one line, quoted where RFC 4180 asks for it. One that a spreadsheet
// would take for a formula begins with an apostrophe (OWASP, "CSV Injection").
std::string csvCell(std::string_view text);

// With a line of names: name, total, out of; points, out of and verdict of each part; seed,
// remarks. Lines end with CR LF. A submission that was left out, or could not be graded, has no
// points, and its remarks say why: 0 would be a mark.
std::string marksCsv(GradedClass graded);

}  // namespace pathmark::report
