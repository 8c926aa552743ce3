// writeFileAtomically: a file is there as a whole, or as it was before.
#pragma once

#include <filesystem>
#include <string_view>

namespace pathmark {

// Throws ImageError with a sentence that names the file and the reason.
void writeFileAtomically(const std::filesystem::path& file, std::string_view content);

}  // namespace pathmark
