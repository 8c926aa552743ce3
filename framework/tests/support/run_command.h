// Running a command as a user would.
//
//   run          keeps what it printed
//   expectSays   whether that is right
#pragma once

#include "host/subprocess.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pathmark::test {

inline ProcessResult run(std::vector<std::string> arguments,
                         const std::filesystem::path& folder = {}) {
  ProcessRequest request;
  request.arguments = std::move(arguments);
  request.folder = folder;
  return runProcess(request);
}

// The command ended with this exit code, and these words are in what it printed.
inline void expectSays(const ProcessResult& result, int exitCode, const std::string& words) {
  EXPECT_EQ(result.exitCode, exitCode) << result.output;
  EXPECT_NE(result.output.find(words), std::string::npos) << result.output;
}

}  // namespace pathmark::test
