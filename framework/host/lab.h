// Labs: a coursework with some of its files replaced, for trying another estimator.
//
//   isLab      whether a folder is one: COURSEWORK/labs/NAME
//   labOwner   the coursework that it belongs to, whose files stand in for those that it has not
//   labNames   the labs of a coursework
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pathmark {

bool isLab(const std::filesystem::path& folder);

// Of a folder that is a lab.
std::filesystem::path labOwner(const std::filesystem::path& folder);

// Sorted; folders without any coursework file are none.
std::vector<std::string> labNames(const std::filesystem::path& coursework);

}  // namespace pathmark
