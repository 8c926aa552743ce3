// Sentences about coursework that does not build.
//
//   whatAFolderHolds   what helps where a file of a folder cannot be had
//   linkFailure        of coursework that does not link, from the linker's words
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace pathmark {

// To go on a sentence with; empty of student/ itself, of which it would say nothing.
std::string_view whatAFolderHolds(const std::filesystem::path& folder);

std::string linkFailure(const std::filesystem::path& folder, const std::string& messages);

}  // namespace pathmark
