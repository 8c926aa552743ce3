// Known wrong ways to make a point of a polygon from two numbers.
#pragma once

#include "checks/outline.h"

#include <string>

namespace pathmark::checks {

// Which of them this function follows, by a grid of points, in words; empty if it is none.
std::string suspectedMap(WorkerProcess& worker, CourseworkFunction sampling,
                         const Outline& outline);

}  // namespace pathmark::checks
