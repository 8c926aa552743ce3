#include "film/atomic_file.h"

#include "film/image.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

// In the same folder, so that renaming does not copy; no longer than a name may be where the
// file's own is not.
std::string scratchPrefix(const fs::path& file) {
  constexpr std::size_t kMostOfTheName = 100;
  return (file.parent_path() / file.filename().string().substr(0, kMostOfTheName)).string();
}

// What is written before it takes the place of another file; gone unless it did. Functions return
// 0 or an errno.
class ScratchFile {
 public:
  enum class Kind { kNameless, kNamed };

  explicit ScratchFile(const fs::path& target) : target_(target), prefix_(scratchPrefix(target)) {}
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() {
    if (fd_ >= 0) close(fd_);
    if (!name_.empty()) unlink(name_.c_str());
  }

  int create(Kind kind) { return kind == Kind::kNameless ? createNameless() : createNamed(); }

  int append(std::string_view content) const {
    while (!content.empty()) {
      const ssize_t n = write(fd_, content.data(), content.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) return errno;
      if (n == 0) return EIO;
      content.remove_prefix(static_cast<std::size_t>(n));
    }
    return 0;
  }

  int takePlace() {
    if (const int error = name_.empty() ? giveName() : 0; error != 0) return error;
    if (const int error = flushAndClose(); error != 0) return error;
    if (rename(name_.c_str(), target_.c_str()) != 0) return errno;
    name_.clear();
    return 0;
  }

 private:
  // A file without a name vanishes with the process, whatever ends it.
  int createNameless() {
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    fd_ = open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
    return fd_ < 0 ? errno : 0;
  }

  int createNamed() {
    std::string name = prefix_ + ".XXXXXX";
    fd_ = mkostemp(name.data(), O_CLOEXEC);
    if (fd_ < 0) return errno;
    name_ = name;
    const mode_t mask = umask(0);
    umask(mask);
    fchmod(fd_, 0666 & ~mask);
    return 0;
  }

  // Only when all of it is written.
  int giveName() {
    if (fsync(fd_) != 0) return errno;
    const std::string nameless = fmt::format("/proc/self/fd/{}", fd_);
    for (int k = 0;; ++k) {
      const std::string name = fmt::format("{}.{}-{}", prefix_, getpid(), k);
      if (linkat(AT_FDCWD, nameless.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
        name_ = name;
        return 0;
      }
      if (errno != EEXIST) return errno;
    }
  }

  // A full disk may be noticed as late as here: file systems allocate when they flush, and network
  // file systems when they close. After EINTR, Linux has closed the file all the same.
  int flushAndClose() {
    const int flushed = fsync(fd_) == 0 ? 0 : errno;
    const int closed = close(fd_) == 0 || errno == EINTR ? 0 : errno;
    fd_ = -1;
    return flushed != 0 ? flushed : closed;
  }

  fs::path target_;
  std::string prefix_;
  std::string name_;  // empty while it has none
  int fd_ = -1;
};

int writeBy(ScratchFile::Kind kind, const fs::path& file,
            std::span<const std::string_view> pieces) {
  ScratchFile scratch(file);
  if (const int error = scratch.create(kind); error != 0) return error;
  for (const std::string_view piece : pieces)
    if (const int error = scratch.append(piece); error != 0) return error;
  return scratch.takePlace();
}

void failIf(const fs::path& file, int error) {
  if (error != 0)
    throw ImageError(fmt::format("{} cannot be written: {}.", file.string(), std::strerror(error)));
}

// What should cost no write: a folder, and a name that is too long.
void refuseName(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) failIf(file, EISDIR);
  struct stat status {};
  if (lstat(file.c_str(), &status) != 0 && errno != ENOENT) failIf(file, errno);
}

}  // namespace

void writeFileAtomically(const fs::path& file, std::string_view content) {
  writeFileAtomically(file, std::span(&content, 1));
}

void writeFileAtomically(const fs::path& file, std::span<const std::string_view> pieces) {
  refuseName(file);
  // Not every file system has nameless files (NFS has not), and giving them a name needs /proc.
  if (writeBy(ScratchFile::Kind::kNameless, file, pieces) == 0) return;
  failIf(file, writeBy(ScratchFile::Kind::kNamed, file, pieces));
}

void tryToWriteBeside(const fs::path& file) {
  refuseName(file);
  ScratchFile scratch(file);
  failIf(file, scratch.create(ScratchFile::Kind::kNamed));
  failIf(file, scratch.append("?"));
}

}  // namespace pathmark
