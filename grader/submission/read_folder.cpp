#include "submission/read_folder.h"

#include "scene/syntax_sentence.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>

namespace pathmark::submission {

namespace {

struct CloseFolder {
  void operator()(DIR* folder) const { closedir(folder); }
};

EntryKind kindOf(mode_t mode) {
  if (S_ISREG(mode)) return EntryKind::kFile;
  if (S_ISDIR(mode)) return EntryKind::kFolder;
  return S_ISLNK(mode) ? EntryKind::kSymbolicLink : EntryKind::kOther;
}

constexpr int kFolderFlags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

class Walk {
 public:
  Walk(const Limits& limits,
       const std::function<void(const Entry& entry, const ReadEntry& read)>& take)
      : limits_(limits), take_(take) {}

  void over(const FolderReader& folder, const std::string& prefix, std::size_t depth) {
    const std::size_t left = limits_.entries - std::min(limits_.entries, seen_);
    const std::vector<FolderEntry> entries = folder.list(left + 1);
    if (entries.size() > left)
      throw Refusal(fmt::format("it holds more than {} files and folders", limits_.entries));
    for (const FolderEntry& found : entries) {
      const bool isFolder = found.kind == EntryKind::kFolder;
      // Compiled programs and histories: many files, none of them the coursework's.
      if (isFolder && (found.name.starts_with('.') || found.name == "build")) continue;
      ++seen_;
      const Entry entry{prefix + found.name, found.kind, false};
      take_(entry, [&](std::size_t atMost) {
        std::optional<std::string> bytes = folder.read(found.name, atMost);
        if (!bytes)
          throw Refusal(
              fmt::format("the file {} cannot be read; may you read it?", shown(entry.path, 100)));
        return *std::move(bytes);
      });
      if (!isFolder || depth == limits_.pathDepth) continue;
      const std::optional<FolderReader> below = folder.openFolder(found.name);
      if (!below)
        throw Refusal(
            fmt::format("the folder {} cannot be read; may you read it?", shown(entry.path, 100)));
      over(*below, entry.path + "/", depth + 1);
    }
  }

 private:
  Limits limits_;
  const std::function<void(const Entry& entry, const ReadEntry& read)>& take_;
  std::size_t seen_ = 0;
};

}  // namespace

std::optional<FolderReader> FolderReader::open(const std::filesystem::path& folder) {
  FileDescriptor descriptor(::open(folder.c_str(), kFolderFlags));
  if (descriptor.get() < 0) return std::nullopt;
  return FolderReader(std::move(descriptor));
}

std::optional<FolderReader> FolderReader::openFolder(const std::string& name) const {
  FileDescriptor descriptor(openat(descriptor_.get(), name.c_str(), kFolderFlags));
  if (descriptor.get() < 0) return std::nullopt;
  return FolderReader(std::move(descriptor));
}

std::vector<FolderEntry> FolderReader::list(std::size_t atMost) const {
  std::vector<FolderEntry> entries;
  // A descriptor of its own, which closedir closes, and whose place in the list is its own.
  const int again = openat(descriptor_.get(), ".", kFolderFlags);
  const std::unique_ptr<DIR, CloseFolder> folder(again < 0 ? nullptr : fdopendir(again));
  if (!folder) {
    if (again >= 0) close(again);
    return entries;
  }
  while (entries.size() < atMost) {
    const dirent* const found = readdir(folder.get());
    if (found == nullptr) break;
    const std::string name = found->d_name;
    if (name == "." || name == "..") continue;
    struct stat status {};
    if (fstatat(descriptor_.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) continue;
    entries.push_back({name, kindOf(status.st_mode)});
  }
  std::sort(entries.begin(), entries.end(),
            [](const FolderEntry& a, const FolderEntry& b) { return a.name < b.name; });
  return entries;
}

std::optional<std::string> FolderReader::read(const std::string& name, std::size_t atMost) const {
  const FileDescriptor file(
      openat(descriptor_.get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (file.get() < 0 || fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode))
    return std::nullopt;
  std::string bytes(std::min(atMost, static_cast<std::size_t>(status.st_size)), '\0');
  std::size_t size = 0;
  while (size < bytes.size()) {
    const ssize_t got = ::read(file.get(), bytes.data() + size, bytes.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::nullopt;
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  bytes.resize(size);
  return bytes;
}

void readFolder(const std::filesystem::path& folder, const Limits& limits,
                const std::function<void(const Entry& entry, const ReadEntry& read)>& take) {
  const std::optional<FolderReader> top = FolderReader::open(folder);
  if (!top) throw Refusal("the folder cannot be read; may you read it?");
  Walk(limits, take).over(*top, "", 1);
}

}  // namespace pathmark::submission
