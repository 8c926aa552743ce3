// The text of a scene or mesh file.
//
//   readText           all of it
//   readTextInPieces   a piece at a time, for files that take more memory than what they say
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace pathmark {

// Throws SceneError if the file is missing, is no regular file, is empty, too large or unreadable;
// `rule` ends the sentence: "a scene is a JSON file".
std::string readText(const std::filesystem::path& file, std::string_view rule);

// `take` returns how much of the text it has used up; the next piece begins with the rest. The last
// is said to be the last, and may be empty.
using TakeText = std::function<std::size_t(std::string_view text, bool isLast)>;
void readTextInPieces(const std::filesystem::path& file, std::string_view rule,
                      const TakeText& take);

}  // namespace pathmark
