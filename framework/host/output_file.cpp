#include "host/output_file.h"

#include "film/image_file.h"
#include "host/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <system_error>

namespace pathmark {

namespace {

// Also of a name that no file can have, or that leads in a circle.
bool isFolder(std::string_view option, const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::none)
    throw UsageError(
        fmt::format("{} {}: this cannot be used ({}).", option, file.string(), error.message()));
  return std::filesystem::is_directory(status);
}

}  // namespace

void requirePlaceForFile(std::string_view option, const std::filesystem::path& file) {
  const std::filesystem::path folder =
      file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (isFolder(option, file))
    throw UsageError(
        fmt::format("{} {}: this is a folder, and a file is needed.", option, file.string()));
  if (!isFolder(option, folder))
    throw UsageError(
        fmt::format("{} {}: there is no folder {}.", option, file.string(), folder.string()));
}

void requireOutput(std::string_view option, const std::filesystem::path& file,
                   std::initializer_list<const char*> endings) {
  const std::string ending = imageEnding(file);
  if (std::none_of(endings.begin(), endings.end(), [&](const char* e) { return ending == e; }))
    throw UsageError(fmt::format("{} {}: the name ends in {}.", option, file.string(),
                                 fmt::join(endings, " or ")));
  requirePlaceForFile(option, file);
}

bool sameFile(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code ignored;
  if (std::filesystem::equivalent(a, b, ignored)) return true;
  // Of a relative name whose first part is not there yet, weakly_canonical would stay relative.
  const auto whole = [&](const std::filesystem::path& file) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file, ignored), ignored);
  };
  return whole(a) == whole(b);
}

}  // namespace pathmark
