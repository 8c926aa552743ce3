// The cache of compiled coursework forgets what nobody uses.
#include "host/build_cache.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <iterator>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t entriesIn(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), {});
}

void fill(const TemporaryFolder& folder, int count, std::chrono::hours age) {
  for (int k = 0; k < count; ++k) {
    const fs::path file = folder / (std::to_string(k) + "-" + std::to_string(age.count()));
    std::ofstream(file) << k;
    fs::last_write_time(file, fs::file_time_type::clock::now() - age);
  }
}

TEST(BuildCache, KeepsTheNewestAndForgetsTheOldest) {
  TemporaryFolder folder;
  fill(folder, 300, std::chrono::hours(48));
  markUsed(folder / "7-48");
  pruneCache(folder.path());
  EXPECT_EQ(entriesIn(folder.path()), 256);
  EXPECT_TRUE(fs::exists(folder / "7-48"));
}

TEST(BuildCache, KeepsWhatMayBeInUse) {
  TemporaryFolder folder;
  fill(folder, 300, std::chrono::hours(0));
  fill(folder, 10, std::chrono::hours(5));
  pruneCache(folder.path());
  EXPECT_EQ(entriesIn(folder.path()), 300);
}

// The files have sizes, and no bytes on the disk.
TEST(BuildCache, ForgetsTheOldestBeyondAFewGigabytes) {
  TemporaryFolder folder;
  for (int k = 0; k < 8; ++k) {
    fs::create_directory(folder / std::to_string(k));
    std::ofstream(folder / std::to_string(k) / "worker");
    fs::resize_file(folder / std::to_string(k) / "worker", std::uintmax_t{1} << 30);
    fs::last_write_time(folder / std::to_string(k),
                        fs::file_time_type::clock::now() - std::chrono::minutes(20 + k));
  }
  markUsed(folder / "7");
  pruneCache(folder.path());
  EXPECT_EQ(entriesIn(folder.path()), 4);
  for (const char* kept : {"7", "0", "1", "2"}) EXPECT_TRUE(fs::exists(folder / kept)) << kept;
}

TEST(BuildCache, KeepsWhatARunMayNeedHoweverLarge) {
  TemporaryFolder folder;
  fill(folder, 8, std::chrono::hours(0));
  for (const auto& entry : fs::directory_iterator(folder.path()))
    fs::resize_file(entry.path(), std::uintmax_t{1} << 30);
  pruneCache(folder.path());
  EXPECT_EQ(entriesIn(folder.path()), 8);
}

TEST(BuildCache, KeepsSmallFoldersAndSurvivesMissingOnes) {
  TemporaryFolder folder;
  fill(folder, 20, std::chrono::hours(1000));
  pruneCache(folder.path());
  EXPECT_EQ(entriesIn(folder.path()), 20);
  pruneCache(folder / "nothing");
}

}  // namespace
}  // namespace pathmark::test
