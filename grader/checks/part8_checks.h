// What is asked of 8.3 where it samples lights.
#pragma once

#include "checks/check.h"

#include <vector>

namespace pathmark::checks::path {

std::vector<Check> lightChecks();

// "unfair-roulette", one of them.
inline constexpr double kRouletteDelta = 0.02;
Finding unfairRoulette(CheckRun& run);

}  // namespace pathmark::checks::path
