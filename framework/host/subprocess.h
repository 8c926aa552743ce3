// runProcess: runs a program to its end and collects what it prints.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pathmark {

struct ProcessRequest {
  std::vector<std::string> arguments;  // the program first, with its path
  std::string input;                   // for standard input
  std::filesystem::path folder;        // to run in; empty: this process's
  double timeLimitSeconds = 120.0;
  std::size_t outputLimit = std::size_t{256}
                            << 10;  // bytes kept of what it prints; the rest is dropped
};

struct ProcessResult {
  int exitCode = -1;      // 128 + signal if a signal ended it
  bool timedOut = false;  // stopped at the time limit
  std::string output;     // standard output and standard error together
};

// Throws std::system_error if the program cannot be started.
ProcessResult runProcess(const ProcessRequest& request);

}  // namespace pathmark
