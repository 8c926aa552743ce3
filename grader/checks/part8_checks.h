// What is asked of 8.3 where it samples lights: part8_light_checks.cpp.
#pragma once

#include "checks/check.h"

#include <vector>

namespace pathmark::checks::path {

std::vector<Check> lightChecks();

}  // namespace pathmark::checks::path
