#include "scene/read_text.h"

#include "scene/load_scene.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <system_error>

namespace pathmark {
namespace {

constexpr std::uintmax_t kMegabyte = std::uintmax_t{1} << 20;
constexpr std::uintmax_t kLargestFile = 256 * kMegabyte;

}  // namespace

std::string readText(const std::filesystem::path& file, std::string_view rule) {
  const auto refuse = [&file](const std::string& sentence) {
    throw SceneError(fmt::format("{}: {}", file.string(), sentence));
  };
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) refuse("there is no such file.");
  if (error) refuse(fmt::format("the file cannot be opened ({}).", error.message()));
  if (std::filesystem::is_directory(status)) {
    refuse(fmt::format("this is a folder, but {}.", rule));
  }
  // A pipe or a device may never end.
  if (!std::filesystem::is_regular_file(status)) {
    refuse(fmt::format("this is a pipe or a device, but {}.", rule));
  }
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) refuse(fmt::format("the file cannot be read ({}).", error.message()));
  if (size == 0) refuse(fmt::format("the file is empty, but {}.", rule));
  if (size > kLargestFile) {
    refuse(fmt::format("the file has {} MB, but it may have at most {} MB.", size / kMegabyte,
                       kLargestFile / kMegabyte));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse("the file cannot be opened; may you read it?");
  std::string text(static_cast<std::size_t>(size), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(size));
  // A file that became shorter meanwhile is judged by what is left of it.
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (stream.bad()) refuse("the file cannot be read to its end.");
  return text;
}

}  // namespace pathmark
