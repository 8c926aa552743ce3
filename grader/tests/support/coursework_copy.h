// CourseworkCopy: a copy of a coursework, by default the solutions, in which things can be broken.
#pragma once

#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace pathmark::test {

inline std::string readAll(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

class CourseworkCopy {
 public:
  explicit CourseworkCopy(const std::filesystem::path& from = std::filesystem::path(PATHMARK_ROOT) /
                                                              "solutions") {
    for (const auto& entry : std::filesystem::directory_iterator(from))
      if (entry.path().extension() == ".cpp")
        std::filesystem::copy_file(entry.path(), folder_ / entry.path().filename().string());
  }

  void replace(const std::string& file, const std::string& from, const std::string& to) {
    std::string text = readAll(folder_ / file);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << file << " has no " << from;
    std::ofstream(folder_ / file) << text.replace(at, from.size(), to);
  }

  const std::filesystem::path& path() const { return folder_.path(); }
  std::string with() const { return path().string(); }
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }

 private:
  TemporaryFolder folder_;
};

}  // namespace pathmark::test
