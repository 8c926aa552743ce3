#include "film/read_bytes.h"

#include "film/image.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <system_error>

namespace pathmark {

namespace {

// stb counts bytes in int. An EXR file of the largest image, uncompressed with variance, has 1.9
// GB.
constexpr std::uintmax_t kMostBytes = std::numeric_limits<std::int32_t>::max();

[[noreturn]] void refuse(const std::string& sentence) { throw ImageError(sentence); }

}  // namespace

std::string readBytes(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) refuse("there is no such file.");
  if (error) refuse(fmt::format("the file cannot be opened: {}.", error.message()));
  if (std::filesystem::is_directory(status)) refuse("this is a folder, and not an image file.");
  // A pipe or a device may never end, and opening one may do something.
  if (!std::filesystem::is_regular_file(status))
    refuse("this is a pipe or a device, and not an image file.");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) refuse(fmt::format("the file cannot be read: {}.", error.message()));
  if (size == 0) refuse("the file is empty, and not an image.");
  if (size > kMostBytes)
    refuse(fmt::format("the file has {} MB, and an image file at most {}.", size >> 20,
                       kMostBytes >> 20));
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse(fmt::format("the file cannot be opened: {}.", std::strerror(errno)));
  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  // A file that became shorter meanwhile is judged by what is left of it.
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (stream.bad()) refuse("the file cannot be read to its end.");
  return bytes;
}

}  // namespace pathmark
