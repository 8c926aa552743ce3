// Running programs.
//
//   runProcess   to their end, collecting what they print
//   awaitEnd     whether one ends in time
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace pathmark {

struct ProcessRequest {
  std::vector<std::string> arguments;  // the program first, with its path
  std::string input;                   // for standard input
  std::filesystem::path folder;        // to run in; empty: this process's
  double timeLimitSeconds = 120.0;
  std::size_t outputLimit = std::size_t{256}
                            << 10;  // bytes kept of what it prints; the rest is dropped

  // Asked several times a second, unless it is empty; if it says no, the process is ended.
  std::function<bool()> goOn = {};
};

struct ProcessResult {
  int exitCode = -1;      // 128 + signal if a signal ended it
  bool timedOut = false;  // stopped at the time limit
  double timeLimitSeconds = 0.0;
  std::string output;    // standard output and standard error together
  bool stopped = false;  // because `goOn` said no
};

// Throws std::system_error if the program cannot be started.
ProcessResult runProcess(const ProcessRequest& request);

// The same with another way of starting it: from the descriptors for its standard input and output
// to a process that leads a group of its own. What is left of the group at the end is killed.
using StartProcess = std::function<pid_t(int input, int output)>;
ProcessResult runProcess(const ProcessRequest& request, const StartProcess& start);

// Leaves it to be waited for.
bool awaitEnd(pid_t child, std::chrono::steady_clock::time_point deadline);

}  // namespace pathmark
