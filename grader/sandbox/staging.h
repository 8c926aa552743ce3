// What sandboxed programs see of this process's files, and where they may write.
//
//   nextUser    an unprivileged user for one program, where this process may choose
//   isShared    whether other programs have the same
//   Staging     a folder of copies that such a user may read, and of scratch folders
#pragma once

#include "host/shared_memory.h"

#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include <sys/types.h>

namespace pathmark::sandbox {

// Nothing unless this process is root's, and nothing where others may not even pass through the
// root folder: they could run no program. Otherwise a number that nobody else has, so that limits
// count the program's own processes alone and signals reach nobody; "nobody" in a container that
// has no such numbers.
std::optional<uid_t> nextUser();

// Whether several programs at the same time may have what nextUser returned.
bool isShared(std::optional<uid_t> user);

// Threads and processes that the user has now.
std::size_t processesOfUser(uid_t user);

class Staging {
 public:
  Staging();   // throws std::system_error, std::runtime_error
  ~Staging();  // removes all of it
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;

  // For root, a copy: others could not reach a checkout in its home. For others the path itself.
  // Throws std::filesystem::filesystem_error.
  std::filesystem::path visible(const std::filesystem::path& path);

  std::filesystem::path makeScratchFolder();  // throws std::system_error

 private:
  using Clock = std::chrono::steady_clock;
  struct Copy {
    std::string stamp;  // of what was copied
    Clock::time_point used;
  };

  void forgetUnused();

  std::filesystem::path folder_;
  FileDescriptor lock_;  // held while the folder is in use
  bool copies_;
  std::mutex mutex_;
  std::map<std::filesystem::path, Copy> staged_;
};

}  // namespace pathmark::sandbox
