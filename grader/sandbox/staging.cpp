#include "sandbox/staging.h"

#include "host/build_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pathmark::sandbox {

namespace fs = std::filesystem;

namespace {

constexpr uid_t kNobody = 65534;
// Above what system users, containers and sub-users are given.
constexpr uid_t kFirstUser = 0x70000000;

constexpr std::string_view kPrefix = "pathmark-sandbox.";

// Longer than a step of compiling or linking may take, which uses copies until its end.
constexpr auto kKeepUnused = std::chrono::minutes(3);

// Holds the lock of a staging folder; nothing if somebody else does, or there is none.
FileDescriptor lockOf(const fs::path& folder, int create) {
  FileDescriptor lock(
      open((folder / "lock").c_str(), O_RDWR | O_CLOEXEC | create, S_IRUSR | S_IWUSR));
  if (lock.get() >= 0 && flock(lock.get(), LOCK_EX | LOCK_NB) != 0) lock.reset();
  return lock;
}

// Whether the lock is held, and of the file that stands in the folder.
bool isLockOf(const fs::path& folder, const FileDescriptor& lock) {
  struct stat held {
  }, there{};
  return lock.get() >= 0 && fstat(lock.get(), &held) == 0 &&
         stat((folder / "lock").c_str(), &there) == 0 && held.st_dev == there.st_dev &&
         held.st_ino == there.st_ino;
}

// The path ends with XXXXXX.
fs::path makeFolder(const fs::path& path) {
  std::string name = path.string();
  if (!mkdtemp(name.data()))
    throw std::system_error(errno, std::generic_category(), "a folder for the sandbox");
  return name;
}

// What processes have left that were killed.
void removeForsaken() {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(fs::temp_directory_path(), error)) {
    struct stat status {};
    if (!entry.path().filename().string().starts_with(kPrefix) ||
        lstat(entry.path().c_str(), &status) != 0 || !S_ISDIR(status.st_mode) ||
        status.st_uid != geteuid())
      continue;
    if (const FileDescriptor lock = lockOf(entry.path(), 0); lock.get() >= 0) {
      std::error_code ignored;
      fs::remove_all(entry.path(), ignored);
    }
  }
}

bool mayBecome(uid_t user) {
  std::ifstream map("/proc/self/uid_map");
  for (std::uint64_t inside = 0, outside = 0, count = 0; map >> inside >> outside >> count;)
    if (user >= inside && user - inside < count) return true;
  return false;
}

// Those are named by what they were made of, and their times say only when they were used last. A
// copy that is written anew may be read by a step that has begun.
bool isCompiledCoursework(const fs::path& path) {
  for (const char* name : {"workers/objects", "workers/linked"}) {
    const fs::path folder = (kBuildFolder / name).lexically_normal();
    if (std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end())
      return true;
  }
  return false;
}

std::string stampOf(const fs::path& path) {
  if (isCompiledCoursework(path)) return "compiled coursework";
  if (!fs::is_regular_file(path)) return "a folder";
  return fmt::format("{} {}", fs::last_write_time(path).time_since_epoch().count(),
                     fs::file_size(path));
}

// A program cannot be executed while it is open for writing, and a process that another thread has
// just made still holds what was open here, until it executes something. A lease on reading is
// granted when there is no writer.
void awaitNoWriter(const fs::path& program) {
  const FileDescriptor file(open(program.c_str(), O_RDONLY | O_CLOEXEC));
  for (int attempt = 0; attempt < 2000; ++attempt) {
    if (fcntl(file.get(), F_SETLEASE, F_RDLCK) == 0) {
      // Not by closing: a new process may hold this descriptor, too, and with it the lease.
      fcntl(file.get(), F_SETLEASE, F_UNLCK);
      return;
    }
    if (errno != EAGAIN) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

// For others to read, whatever it was.
void copyReadable(const fs::path& from, const fs::path& to) {
  const bool folder = fs::is_directory(from);
  if (folder) {
    fs::create_directories(to);
    for (const auto& entry : fs::directory_iterator(from))
      copyReadable(entry.path(), to / entry.path().filename());
  } else {
    fs::copy_file(from, to, fs::copy_options::overwrite_existing);
  }
  const bool program = (fs::status(from).permissions() & fs::perms::owner_exec) != fs::perms::none;
  chmod(to.c_str(), folder || program ? 0755 : 0644);
  if (program && !folder) awaitNoWriter(to);
}

}  // namespace

std::optional<uid_t> nextUser() {
  struct stat top {};
  if (geteuid() != 0 || stat("/", &top) != 0 || (top.st_mode & S_IXOTH) == 0) return std::nullopt;
  static std::atomic<uid_t> count{0};
  const uid_t user =
      kFirstUser | ((static_cast<uid_t>(getpid()) & 0xffff) << 12) | (count++ & 0xfff);
  return mayBecome(user) ? user : kNobody;
}

bool isShared(std::optional<uid_t> user) { return !user || *user == kNobody; }

std::size_t processesOfUser(uid_t user) {
  std::size_t count = 0;
  std::error_code error;
  for (const auto& process : fs::directory_iterator("/proc", error)) {
    struct stat status {};
    if (stat(process.path().c_str(), &status) != 0 || status.st_uid != user) continue;
    for (fs::directory_iterator task(process.path() / "task", error), end; !error && task != end;
         task.increment(error))
      ++count;
  }
  return count;
}

// Another process that looks for what is forsaken may lock and remove the new folder before it is
// locked here.
Staging::Staging() : copies_(geteuid() == 0) {
  constexpr int kMostAttempts = 100;
  removeForsaken();
  for (int attempt = 0; attempt < kMostAttempts && lock_.get() < 0; ++attempt) {
    folder_ = makeFolder(fs::temp_directory_path() / (std::string(kPrefix) + "XXXXXX"));
    // Passable for those who know a name in it.
    chmod(folder_.c_str(), 0711);
    lock_ = lockOf(folder_, O_CREAT);
    if (!isLockOf(folder_, lock_)) {
      lock_.reset();
      std::error_code ignored;
      fs::remove_all(folder_, ignored);
    }
  }
  if (lock_.get() < 0) throw std::runtime_error("a folder for the sandbox cannot be locked");
  fs::create_directory(folder_ / "scratch");
  chmod((folder_ / "scratch").c_str(), 0711);
}

Staging::~Staging() {
  std::error_code error;
  fs::remove_all(folder_, error);
}

fs::path Staging::visible(const fs::path& path) {
  fs::path own = fs::absolute(path).lexically_normal();
  if (!copies_) return own;
  fs::path copy = folder_ / "files" / own.relative_path();
  const std::lock_guard lock(mutex_);
  std::string stamp = stampOf(own);
  const auto known = staged_.find(own);
  if (known != staged_.end() && known->second.stamp == stamp) {
    known->second.used = Clock::now();
    return copy;
  }
  forgetUnused();
  // Folders on the way, too, for others to pass.
  const mode_t mask = umask(022);
  fs::create_directories(copy.parent_path());
  copyReadable(own, copy);
  umask(mask);
  staged_[own] = {std::move(stamp), Clock::now()};
  return copy;
}

// The workers of a large class would fill the disk. Running ones keep their copies' contents.
void Staging::forgetUnused() {
  for (auto copy = staged_.begin(); copy != staged_.end();) {
    if (Clock::now() - copy->second.used < kKeepUnused) {
      ++copy;
      continue;
    }
    std::error_code ignored;
    fs::remove_all(folder_ / "files" / copy->first.relative_path(), ignored);
    copy = staged_.erase(copy);
  }
}

fs::path Staging::makeScratchFolder() { return makeFolder(folder_ / "scratch/XXXXXX"); }

}  // namespace pathmark::sandbox
