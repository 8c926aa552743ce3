// readText: the whole of a scene or mesh file as text.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace pathmark {

// Throws SceneError if the file is missing, is no regular file, is empty, too large or unreadable;
// `rule` ends the sentence: "a scene is a JSON file".
std::string readText(const std::filesystem::path& file, std::string_view rule);

}  // namespace pathmark
