// The checks of part 2 come in three files.
#pragma once

#include "checks/check.h"

#include <vector>

namespace pathmark::checks {

std::vector<Check> polygonChecks();         // 2.1, 2.2, 2.3
std::vector<Check> sphereLightChecks();     // 2.4, 2.5
std::vector<Check> directLightingChecks();  // 2.6

}  // namespace pathmark::checks
