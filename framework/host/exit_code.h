// What the program's exit code says.
#pragma once

namespace pathmark {

// compare has its own: see command_compare.cpp.
enum ExitCode : int {
  kSuccess = 0,
  kCourseworkFault = 1,  // does not compile, crashed, was stopped, or returned invalid values
  kUsageFault = 2,       // the command line, or a scene
  kMachineFault = 3,     // a file that cannot be written, a tool that cannot be run
  kInterrupted = 130,    // Ctrl-C
};

}  // namespace pathmark
