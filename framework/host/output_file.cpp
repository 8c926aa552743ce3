#include "host/output_file.h"

#include "host/session.h"

#include <fmt/format.h>

namespace pathmark {

void requirePlaceForFile(std::string_view option, const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file))
    throw UsageError(
        fmt::format("{} {}: this is a folder, and a file is needed.", option, file.string()));
  const std::filesystem::path folder =
      file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder))
    throw UsageError(
        fmt::format("{} {}: there is no folder {}.", option, file.string(), folder.string()));
}

}  // namespace pathmark
