// What is known of a worker that is ending, or must.
//
//   endOf             how it ended
//   faultOf           what its crash record stands for
//   threadNumber      a thread's number here, from its number in the worker's own namespace
//   killInner         kills a worker that has a process in front of it
#pragma once

#include "host/worker_process.h"

#include <optional>

#include <sys/types.h>

namespace pathmark {

struct WorkerEnd {
  std::optional<int> signal;
  int exitCode = 0;
};

// From what waitpid says; `relayed` by the process in front of the worker.
WorkerEnd endOf(int status, bool relayed);

WorkerFault faultOf(const CrashRecord& record);
WorkerFault faultOfSignal(int signal);

// `process` has numbers of its own for its threads; nothing if there is no such thread any more.
std::optional<pid_t> threadNumber(pid_t process, int inner);

void killInner(const FileDescriptor& handle);

}  // namespace pathmark
