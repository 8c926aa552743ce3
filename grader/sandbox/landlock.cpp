#include "sandbox/landlock.h"

#include <cerrno>
#include <cstdint>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace pathmark::sandbox {

namespace {

// The kernel's interface as of version 7, for headers that are older than the kernel.
struct RulesetAttributes {
  std::uint64_t files = 0, network = 0, scopes = 0;
};
struct [[gnu::packed]] PathRule {
  std::uint64_t access = 0;
  std::int32_t parent = -1;
};

constexpr unsigned kVersionFlag = 1;
constexpr int kPathBeneath = 1;

constexpr std::uint64_t kExecute = 1 << 0, kWriteFile = 1 << 1, kReadFile = 1 << 2,
                        kReadFolder = 1 << 3, kRemoveFolder = 1 << 4, kRemoveFile = 1 << 5,
                        kMakeFolder = 1 << 7, kMakeFile = 1 << 8, kTruncate = 1 << 14;
constexpr std::uint64_t kOfFiles = kExecute | kWriteFile | kReadFile | kTruncate;

// Rights, by the version that brought them.
constexpr std::uint64_t fileRights(int version) {
  if (version >= 5) return (1 << 16) - 1;               // devices' controls
  if (version >= 3) return (1 << 15) - 1;               // truncating
  return version == 2 ? (1 << 14) - 1 : (1 << 13) - 1;  // linking between folders
}
constexpr std::uint64_t networkRights(int version) { return version >= 4 ? 3 : 0; }
constexpr std::uint64_t scopes(int version) { return version >= 6 ? 3 : 0; }

std::size_t attributeBytes(int version) {
  if (version >= 6) return sizeof(RulesetAttributes);
  return version >= 4 ? 2 * sizeof(std::uint64_t) : sizeof(std::uint64_t);
}

}  // namespace

int landlockVersion() {
  const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, kVersionFlag);
  return version > 0 ? static_cast<int>(version) : 0;
}

AccessRules::AccessRules() : version_(landlockVersion()) {
  const RulesetAttributes attributes{fileRights(version_), networkRights(version_),
                                     scopes(version_)};
  rules_ = FileDescriptor(static_cast<int>(
      syscall(SYS_landlock_create_ruleset, &attributes, attributeBytes(version_), 0)));
  if (rules_.get() < 0) throw std::system_error(errno, std::generic_category(), "Landlock");
}

void AccessRules::allow(int descriptor, unsigned long long access) {
  struct stat status {};
  if (fstat(descriptor, &status) == 0 && !S_ISDIR(status.st_mode)) access &= kOfFiles;
  const PathRule rule{access & fileRights(version_), descriptor};
  if (syscall(SYS_landlock_add_rule, rules_.get(), kPathBeneath, &rule, 0) != 0)
    throw std::system_error(errno, std::generic_category(), "Landlock");
}

void AccessRules::allow(const std::filesystem::path& path, unsigned long long access) {
  const FileDescriptor file(open(path.c_str(), O_PATH | O_CLOEXEC));
  if (file.get() >= 0) allow(file.get(), access);
}

void AccessRules::allowReading(const std::filesystem::path& path) {
  allow(path, kExecute | kReadFile | kReadFolder);
}

void AccessRules::allowReading(int descriptor) {
  allow(descriptor, kExecute | kReadFile | kReadFolder);
}

void AccessRules::allowWriting(const std::filesystem::path& folder) {
  allow(folder, kReadFile | kReadFolder | kWriteFile | kTruncate | kMakeFile | kRemoveFile |
                    kMakeFolder | kRemoveFolder);
}

bool obeyRules(int descriptor) { return syscall(SYS_landlock_restrict_self, descriptor, 0) == 0; }

}  // namespace pathmark::sandbox
