// What is asked of single paths of 5.1: part5_single_path_checks.cpp. Means over many are in
// part5_checks.cpp.
#pragma once

#include "checks/check.h"

namespace pathmark::checks::path {

Finding emissionIsSeen(CheckRun& run);
Finding radianceIsValid(CheckRun& run);
Finding sameNumbersSameRadiance(CheckRun& run);
Finding twiceTheEmission(CheckRun& run);

}  // namespace pathmark::checks::path
