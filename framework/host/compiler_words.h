// What the compiler says, as short as a person wants it.
#pragma once

#include <string>

namespace pathmark {

// Without the functions of libraries that would not fit a call either: to one operator of colours
// belong a hundred lines of them. Where a double meets a vector of float, a line says so.
std::string shortCompilerWords(const std::string& output);

}  // namespace pathmark
