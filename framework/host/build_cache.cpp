#include "host/build_cache.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <system_error>
#include <utility>
#include <vector>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kEntriesToKeep = 256;
constexpr std::uintmax_t kBytesToKeep = std::uintmax_t{4} << 30;

// Between two uses of what a run still needs.
constexpr auto kSafeAge = std::chrono::hours(1);
// The same, where a full disk is worse: longer than a submission may take.
constexpr auto kSafeAgeOfMany = std::chrono::minutes(15);

struct Entry {
  fs::file_time_type used;
  fs::path path;
  std::uintmax_t bytes = 0;
};

// Of a file, or of the files in a folder.
std::uintmax_t bytesOf(const fs::directory_entry& entry) {
  std::error_code error;
  if (!entry.is_directory(error)) {
    const std::uintmax_t bytes = entry.file_size(error);
    return error ? 0 : bytes;
  }
  std::uintmax_t sum = 0;
  for (const auto& below : fs::directory_iterator(entry.path(), error))
    if (!below.is_directory(error)) sum += bytesOf(below);
  return sum;
}

std::vector<Entry> newestFirst(const fs::path& folder) {
  std::vector<Entry> entries;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    entries.push_back({fs::last_write_time(entry, error), entry.path(), bytesOf(entry)});
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::pair(a.used, a.path) > std::pair(b.used, b.path);
  });
  return entries;
}

}  // namespace

void markUsed(const fs::path& entry) {
  std::error_code ignored;
  fs::last_write_time(entry, fs::file_time_type::clock::now(), ignored);
}

void pruneCache(const fs::path& folder) {
  const auto now = fs::file_time_type::clock::now();
  std::size_t count = 0;
  std::uintmax_t bytes = 0;
  for (const Entry& entry : newestFirst(folder)) {
    bytes += entry.bytes;
    const bool forgotten = ++count > kEntriesToKeep && entry.used < now - kSafeAge;
    const bool large = bytes > kBytesToKeep && entry.used < now - kSafeAgeOfMany;
    std::error_code ignored;
    if (forgotten || large) fs::remove_all(entry.path, ignored);
  }
}

}  // namespace pathmark
