// launchWorker: starts a worker program with its descriptors in place and its limits set.
#pragma once

#include "host/shared_memory.h"

#include <cstddef>
#include <filesystem>

#include <sys/types.h>

namespace pathmark {

struct LaunchedWorker {
  pid_t pid = -1;         // also its process group
  FileDescriptor socket;  // requests and replies
  FileDescriptor text;    // what it prints to standard output and standard error
  FileDescriptor crash;   // crash records
};

// The worker gets an empty standard input, no other descriptors of this process, and dies with
// it. Throws std::system_error.
LaunchedWorker launchWorker(const std::filesystem::path& program, std::size_t memoryBytes);

}  // namespace pathmark
