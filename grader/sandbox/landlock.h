// Landlock: access rules that a process lays on itself.
//
//   landlockVersion    of the kernel; 0 if it has none
//   AccessRules        which files may be reached, as a descriptor for the kernel
#pragma once

#include "host/shared_memory.h"

#include <filesystem>

namespace pathmark::sandbox {

int landlockVersion();

// Everything is refused that the kernel knows how to refuse, but for what is allowed: files,
// TCP, abstract sockets, signals to processes outside. All functions throw std::system_error.
class AccessRules {
 public:
  AccessRules();

  // A file, or a folder and all in it. One that does not exist is passed over.
  void allowReading(const std::filesystem::path& path);
  void allowReading(int descriptor);
  void allowWriting(const std::filesystem::path& folder);

  int descriptor() const { return rules_.get(); }

 private:
  void allow(int descriptor, unsigned long long access);
  void allow(const std::filesystem::path& path, unsigned long long access);

  int version_;
  FileDescriptor rules_;
};

// For the calling process, which must have given up new privileges. Between fork and exec. Returns
// whether the rules hold.
bool obeyRules(int descriptor);

}  // namespace pathmark::sandbox
