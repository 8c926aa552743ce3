// What is asked of single paths: part5_single_path_checks.cpp, of what each bounce adds:
// part5_bounce_checks.cpp. Other means over many paths are in part5_checks.cpp. All of it is asked
// of both path tracers, 5.1 and 8.3.
#pragma once

#include "checks/check.h"

namespace pathmark::checks::path {

Finding emissionIsSeen(CheckRun& run);
Finding radianceIsValid(CheckRun& run);
Finding sameNumbersSameRadiance(CheckRun& run);
Finding twiceTheEmission(CheckRun& run);

inline constexpr double kBounceDelta = 0.01;  // of the weight of one bounce
Finding bouncesAdd(CheckRun& run);

// Where a check has failed without a cause: whether it is that rays start at hit.p. Next to a plate
// of which all points have the height 0, the point of a hit lies on it exactly; elsewhere beside
// it, by a rounding.
void addCauseOfRoundedStart(CheckRun& run, Finding& finding);

// Of tracePath or tracePathMIS.
std::vector<Check> checksOf(CourseworkFunction pathTracer);

}  // namespace pathmark::checks::path
