// Part 0 in four groups, in the order of the handout.
#pragma once

#include "checks/check.h"

#include <vector>

namespace pathmark::checks {

std::vector<Check> part0IntersectionChecks();  // 0.1, 0.2
std::vector<Check> part0SamplingChecks();      // 0.3 to 0.5
std::vector<Check> part0RadianceChecks();      // 0.6, 0.7
std::vector<Check> part0BackChecks();          // 0.7

}  // namespace pathmark::checks
