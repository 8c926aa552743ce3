// projectFiles: what there is to choose from when a kit is made.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pathmark::kit {

// The files of the project, relative to its folder and sorted: those that git knows, or where the
// project is not kept with git, all that lie in it but for its build folder and what git would have
// of its own.
std::vector<std::string> projectFiles(const std::filesystem::path& project);

// All of a file. Throws std::runtime_error with a sentence if it cannot be read.
std::string readFile(const std::filesystem::path& file);

}  // namespace pathmark::kit
