// Hints: up to three for each function, from a nudge to nearly the answer.
#pragma once

#include "worker/contract.h"

#include <string>
#include <vector>

namespace pathmark {

inline constexpr int kMostHints = 3;

// Throws std::runtime_error if the file of hints is missing or damaged.
std::vector<std::string> hintsFor(const FunctionContract& function);

}  // namespace pathmark
