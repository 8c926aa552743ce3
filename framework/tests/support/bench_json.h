// Running pathmark bench as a user would, and reading what it writes.
#pragma once

#include "host/subprocess.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace pathmark::test {

class BenchCommand : public testing::Test {
 protected:
  ProcessResult bench(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {PATHMARK_PROGRAM, "bench"});
    ProcessRequest request;
    request.arguments = std::move(arguments);
    request.folder = folder_.path();
    request.timeLimitSeconds = 900.0;  // with sanitizers
    return runProcess(request);
  }

  // Of a run that must succeed.
  nlohmann::json benchJson(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "bench.json"});
    const ProcessResult result = bench(std::move(arguments));
    EXPECT_EQ(result.exitCode, 0) << result.output;
    output_ = result.output;
    std::ifstream file(folder_ / "bench.json");
    return nlohmann::json::parse(file, nullptr, false);
  }

  void expectRefuses(std::vector<std::string> arguments, const std::string& words) {
    const ProcessResult result = bench(std::move(arguments));
    EXPECT_EQ(result.exitCode, 2) << result.output;
    EXPECT_NE(result.output.find(words), std::string::npos) << result.output;
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
  }

  TemporaryFolder folder_;
  std::string output_;
};

}  // namespace pathmark::test
