// What marks depend on besides coursework, seed and rubric.
#pragma once

#include "record/record.h"

#include <string>

namespace pathmark::grading {

// Of this program, its workers and its solutions, on this machine.
record::BuildRecord thisBuild(const std::string& sandbox);

}  // namespace pathmark::grading
