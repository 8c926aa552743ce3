// What the tests of collecting share.
#pragma once

#include "submission/submission.h"
#include "support/made_archive.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace pathmark::submission {

inline std::string allRemarks(const Collected& collected) {
  std::string all = collected.failure + "\n";
  for (const std::string& remark : collected.remarks) all += remark + "\n";
  return all;
}

inline std::vector<std::string> names(const Collected& collected) {
  std::vector<std::string> all;
  for (const auto& [name, bytes] : collected.files) all.push_back(name);
  return all;
}

inline void expectRemark(const Collected& collected, std::string_view words) {
  EXPECT_NE(allRemarks(collected).find(words), std::string::npos)
      << "no remark says \"" << words << "\":\n"
      << allRemarks(collected);
}

// Archives and folders in a folder of their own.
class Collecting : public testing::Test {
 protected:
  Collected collected(const test::MadeArchive& made,
                      test::ArchiveKind kind = test::ArchiveKind::kTar, const Limits& limits = {}) {
    const std::filesystem::path file = folder_ / "submission.archive";
    made.write(kind, file);
    return collect({"submission", file, true}, limits);
  }
  Collected collectedFile(std::string_view bytes, const Limits& limits = {}) {
    const std::filesystem::path file = folder_ / "submission.archive";
    test::writeBytes(file, bytes);
    return collect({"submission", file, true}, limits);
  }
  Collected collectedFolder(const Limits& limits = {}) {
    return collect({"submission", folder_ / "submission", false}, limits);
  }
  void write(const std::string& name, std::string_view bytes = "x") {
    test::writeBytes(folder_ / ("submission/" + name), bytes);
  }

  test::TemporaryFolder folder_;
};

}  // namespace pathmark::submission
