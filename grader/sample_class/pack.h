// packFolder: a zip or a compressed tar of a folder, as students hand it in.
#pragma once

#include <filesystem>

namespace pathmark {

// The folder itself wraps the files. Throws std::runtime_error.
void packFolder(const std::filesystem::path& folder, const std::filesystem::path& archive,
                bool asZip);

}  // namespace pathmark
