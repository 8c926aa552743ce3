#include "film/atomic_file.h"

#include "film/image.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

// Each returns 0 or an errno.

int writeAll(int fd, std::string_view content) {
  while (!content.empty()) {
    const ssize_t n = write(fd, content.data(), content.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    if (n == 0) return EIO;
    content.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}

// A full disk may be noticed as late as here: file systems allocate when they flush, and network
// file systems when they close. After EINTR, Linux has closed the file all the same.
int flushAndClose(int fd) {
  const int flushed = fsync(fd) == 0 ? 0 : errno;
  const int closed = close(fd) == 0 || errno == EINTR ? 0 : errno;
  return flushed != 0 ? flushed : closed;
}

// In the same folder, so that renaming does not copy; no longer than a name may be where the
// file's own is not.
std::string scratchName(const fs::path& file) {
  constexpr std::size_t kMostOfTheName = 100;
  const std::string name = file.filename().string().substr(0, kMostOfTheName) + ".XXXXXX";
  return (file.parent_path() / name).string();
}

}  // namespace

void writeFileAtomically(const fs::path& file, std::string_view content) {
  const auto failIf = [&](int error) {
    if (error != 0)
      throw ImageError(
          fmt::format("{} cannot be written: {}.", file.string(), std::strerror(error)));
  };
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) failIf(EISDIR);
  // A name that is too long should cost no write.
  struct stat status {};
  if (lstat(file.c_str(), &status) != 0 && errno != ENOENT) failIf(errno);
  std::string scratch = scratchName(file);
  const int fd = mkostemp(scratch.data(), O_CLOEXEC);
  if (fd < 0) failIf(errno);
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(fd, 0666 & ~mask);
  int error = writeAll(fd, content);
  const int late = flushAndClose(fd);
  if (error == 0) error = late;
  if (error == 0 && rename(scratch.c_str(), file.c_str()) != 0) error = errno;
  if (error != 0) unlink(scratch.c_str());
  failIf(error);
}

}  // namespace pathmark
