// What a change of a coursework file may change.
//
//   functionsThatMayDiffer   the functions of a part whose results may not be the old ones
//
// What a change cannot reach need not be tried again.
#pragma once

#include "worker/contract.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace pathmark {

// Of two versions of a part's file: the functions whose definition differs; those that mention a
// name whose definition differs, and so on; and then those that take a scene, since they may meet
// any other through it. All functions of the part where that cannot be told: where types,
// templates, macros or includes differ, or braces do not match.
std::vector<CourseworkFunction> functionsThatMayDiffer(int part, std::string_view before,
                                                       std::string_view after);

// Of the part's file in two folders.
std::vector<CourseworkFunction> functionsThatMayDifferIn(int part,
                                                         const std::filesystem::path& before,
                                                         const std::filesystem::path& after);

}  // namespace pathmark
