// Files that are there as a whole, or as they were before.
//
//   writeFileAtomically   replaces a file in one step
//   tryToWriteBeside      whether that could be done at all
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace pathmark {

// Throws ImageError with a sentence that names the file and the reason.
void writeFileAtomically(const std::filesystem::path& file, std::string_view content);

// The same for content in several pieces.
void writeFileAtomically(const std::filesystem::path& file,
                         std::span<const std::string_view> pieces);

// Makes a small file in the same folder, and removes it again. Throws ImageError as
// writeFileAtomically would.
void tryToWriteBeside(const std::filesystem::path& file);

}  // namespace pathmark
