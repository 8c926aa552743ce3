// stampOf: whether a coursework has changed, for watching its folder.
#pragma once

#include <filesystem>
#include <string>

namespace pathmark {

// Changes whenever a coursework file or a scene of its own does. By names, sizes and times alone:
// nothing is read, so that it can be asked ten times a second.
std::string stampOf(const std::filesystem::path& folder);

}  // namespace pathmark
