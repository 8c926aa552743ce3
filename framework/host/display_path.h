// How a path is shown to a person.
#pragma once

#include <filesystem>
#include <string>

namespace pathmark {

// Relative to the folder that the command was called in where that goes only downwards, else
// whole.
inline std::string displayPath(const std::filesystem::path& path) {
  const std::filesystem::path relative = std::filesystem::proximate(path);
  const bool upwards = !relative.empty() && *relative.begin() == "..";
  return upwards ? std::filesystem::absolute(path).lexically_normal().string() : relative.string();
}

}  // namespace pathmark
