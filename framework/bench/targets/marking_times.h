// How long a student waits for checks, and an instructor for marks.
//
//   addMarkingTimes   adds the figures of both to a report
#pragma once

#include "bench/progress.h"
#include "bench/report.h"

#include <filesystem>

namespace pathmark::bench {

// Of a copy of the coursework in `scratch`, without the bonus parts, of which one file has just
// been changed (check) or no file is compiled yet (grade, where there is such a command). Throws
// CourseworkError if one fails.
void addMarkingTimes(const std::filesystem::path& coursework, const std::filesystem::path& scratch,
                     Progress& progress, Report& report);

}  // namespace pathmark::bench
