// Folders that students filled: no link in them is followed, and no pipe or device is opened.
//
//   FolderReader   lists a folder and opens what is in it, one name at a time
//   readFolder     everything in a folder and below it, as entries
#pragma once

#include "host/shared_memory.h"
#include "submission/entry.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pathmark::submission {

struct FolderEntry {
  std::string name;
  EntryKind kind = EntryKind::kFile;
};

class FolderReader {
 public:
  // Nothing if it is no folder, a link to one, or may not be read.
  static std::optional<FolderReader> open(const std::filesystem::path& folder);
  std::optional<FolderReader> openFolder(const std::string& name) const;

  // Sorted by name, no more than `atMost`.
  std::vector<FolderEntry> list(std::size_t atMost) const;

  // The first `atMost` bytes of a regular file. Nothing if it is none, or may not be read.
  std::optional<std::string> read(const std::string& name, std::size_t atMost) const;

 private:
  explicit FolderReader(FileDescriptor descriptor) : descriptor_(std::move(descriptor)) {}

  FileDescriptor descriptor_;
};

// Hidden folders and build/ are left out. Throws Refusal beyond the limits.
void readFolder(const std::filesystem::path& folder, const Limits& limits,
                const std::function<void(const Entry& entry, const ReadEntry& read)>& take);

}  // namespace pathmark::submission
