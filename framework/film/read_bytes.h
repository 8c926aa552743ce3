// readBytes: the whole of an image file.
#pragma once

#include <filesystem>
#include <string>

namespace pathmark {

// Throws ImageError, without the file's name, if there is no such file, or if it is a folder or a
// device, empty, too large or unreadable.
std::string readBytes(const std::filesystem::path& file);

}  // namespace pathmark
