#include "host/build_cache.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <system_error>
#include <utility>
#include <vector>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kEntriesToKeep = 256;
constexpr auto kSafeAge = std::chrono::hours(1);

}  // namespace

void markUsed(const fs::path& entry) {
  std::error_code ignored;
  fs::last_write_time(entry, fs::file_time_type::clock::now(), ignored);
}

void pruneCache(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, fs::path>> entries;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    entries.emplace_back(fs::last_write_time(entry, error), entry.path());
  if (entries.size() <= kEntriesToKeep) return;
  std::sort(entries.begin(), entries.end(), std::greater<>());
  const auto safe = fs::file_time_type::clock::now() - kSafeAge;
  for (auto entry = entries.begin() + kEntriesToKeep; entry != entries.end(); ++entry)
    if (entry->first < safe) fs::remove_all(entry->second, error);
}

}  // namespace pathmark
