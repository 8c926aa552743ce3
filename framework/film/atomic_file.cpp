#include "film/atomic_file.h"

#include "film/image.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pathmark {

namespace {

bool writeAll(int fd, std::string_view content) {
  while (!content.empty()) {
    const ssize_t n = write(fd, content.data(), content.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(n));
  }
  return fsync(fd) == 0;
}

}  // namespace

void writeFileAtomically(const std::filesystem::path& file, std::string_view content) {
  const auto fail = [&](int error) {
    throw ImageError(fmt::format("{} cannot be written: {}.", file.string(), std::strerror(error)));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) fail(EISDIR);
  std::string scratch = file.string() + ".XXXXXX";
  const int fd = mkostemp(scratch.data(), O_CLOEXEC);
  if (fd < 0) fail(errno);
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(fd, 0666 & ~mask);
  const bool written = writeAll(fd, content);
  const int writeError = errno;
  close(fd);
  if (!written || rename(scratch.c_str(), file.c_str()) != 0) {
    const int error = written ? errno : writeError;
    unlink(scratch.c_str());
    fail(error);
  }
}

}  // namespace pathmark
