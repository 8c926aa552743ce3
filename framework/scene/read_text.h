// readText: the whole of a scene file as text.
#pragma once

#include <filesystem>
#include <string>

namespace pathmark {

// Throws SceneError if the file is missing, is no regular file, is empty, too large or unreadable.
std::string readText(const std::filesystem::path& file);

}  // namespace pathmark
