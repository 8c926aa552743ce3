// A small class that is graded by the real program.
//
//   GradeCommand   makes it, and runs pathmark grade
//   rowOf          a submission's row of marks.csv
//   kWeight        what mistakes of the part that is graded replace
#pragma once

#include "support/background_program.h"
#include "support/coursework_copy.h"
#include "support/run_command.h"
#include "support/test_coursework_files.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace pathmark::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

inline const fs::path kRoot = PATHMARK_ROOT;

inline std::string quoted(const fs::path& path) { return path.string(); }

// Of the last part only, which is the quickest to grade.
class GradeCommand : public testing::Test {
 protected:
  void add(const std::string& name, const std::string& from = {}, const std::string& to = {}) {
    CourseworkCopy copy;
    if (!from.empty()) copy.replace("part6_roulette.cpp", from, to);
    fs::create_directories(classFolder());
    fs::copy(copy.with(), classFolder() / name, fs::copy_options::recursive);
  }

  std::vector<std::string> command(std::vector<std::string> more = {}) const {
    std::vector<std::string> words{PATHMARK_PROGRAM, "grade",       quoted(classFolder()),
                                   "--out",          quoted(out()), "--only",
                                   "part6"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  ProcessResult grade(std::vector<std::string> more = {}) const {
    return run(command(std::move(more)), kRoot);
  }

  fs::path classFolder() const { return folder_ / "class"; }
  fs::path out() const { return folder_ / "grades"; }
  fs::path recordOf(const std::string& name) const {
    return out() / "submissions" / name / "record.json";
  }
  Json record(const std::string& name) const { return Json::parse(textOf(recordOf(name))); }

  TemporaryFolder folder_;
};

// A marked row's points, from marks.csv.
inline std::string rowOf(const std::string& csv, const std::string& name) {
  const std::size_t at = csv.find("\n" + name + ",");
  return at == std::string::npos ? "" : csv.substr(at + 1, csv.find('\n', at + 1) - at - 1);
}

inline constexpr const char* kWeight = "return {true, 1.0f / q};";

}  // namespace pathmark::test
