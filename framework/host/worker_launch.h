// launchWorker: starts a worker program with its descriptors in place and its limits set.
//
//   memoryForWorker   how much a worker may have
#pragma once

#include "host/shared_memory.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include <sys/types.h>

namespace pathmark {

struct LaunchedWorker {
  pid_t pid = -1;         // to wait for; also its process group
  FileDescriptor socket;  // requests and replies
  FileDescriptor text;    // what it prints to standard output and standard error
  FileDescriptor crash;   // crash records

  // Where another process stands in front of the worker: the worker itself, with thread numbers of
  // its own, and a descriptor of it (pidfd_open). That other process ends when the worker does,
  // with 128 + signal where a signal ended it.
  pid_t inner = -1;
  FileDescriptor innerHandle;

  // Asked after its end: a sentence if the machine failed before the worker began.
  std::function<std::string()> startFailure;
};

// The host's side of a new worker and the worker's.
struct WorkerChannels {
  WorkerChannels();  // throws std::system_error
  FileDescriptor socket, text, crash;
  FileDescriptor workerSocket, workerText, workerCrash;
};

// Puts the worker's ends where it expects them, with an empty standard input. Between fork and
// exec: only calls that are safe there. Other descriptors stay open.
void placeWorkerDescriptors(int socket, int text, int crash);

// Bytes of address space: half of the machine's memory, at least 1 GiB and at most 8. Coursework
// that allocates without end is refused more before the machine is short of it.
std::size_t memoryForWorker();

// The worker gets an empty standard input, no other descriptors of this process, and dies with
// it. Where memory runs out nonetheless, it is the first to be killed. Throws std::system_error.
LaunchedWorker launchWorker(const std::filesystem::path& program, std::size_t memoryBytes);

}  // namespace pathmark
