// What can be known of an output file before the work for it begins.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string_view>

namespace pathmark {

// Throws UsageError with a sentence if `file`, the value of `option`, is a folder or lies in none.
void requirePlaceForFile(std::string_view option, const std::filesystem::path& file);

// The same if its name ends in none of `endings`: small letters, with the dot.
void requireOutput(std::string_view option, const std::filesystem::path& file,
                   std::initializer_list<const char*> endings);

// Whether both names are of one file, which need not be there yet.
bool sameFile(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace pathmark
