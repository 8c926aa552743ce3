// Running whole programs to measure them.
//
//   ChildUsage     what a program took, with all the processes that it started and waited for
//   runMeasured    runs one to its end
//   PeakMemory     how much memory a program and its own child held at most
//   measureMemory  runs one to its end, looking
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pathmark::bench {

struct ChildUsage {
  int exitCode = -1;  // 128 + signal if a signal ended it
  double wallSeconds = 0.0;
  double cpuSeconds = 0.0;  // user and system, of the program and of its children
};

// What it prints goes to the file `log`. Throws std::system_error if it cannot be started.
ChildUsage runMeasured(const std::vector<std::string>& arguments, const std::filesystem::path& log);

// Bytes that were resident at most: the kernel's VmHWM, looked at every millisecond, because what
// it tells of an ended process (ru_maxrss) includes the process that started it.
struct PeakMemory {
  int exitCode = -1;
  std::uint64_t program = 0;
  std::uint64_t children = 0;

  std::uint64_t sum() const { return program + children; }
};

PeakMemory measureMemory(const std::vector<std::string>& arguments,
                         const std::filesystem::path& log);

}  // namespace pathmark::bench
