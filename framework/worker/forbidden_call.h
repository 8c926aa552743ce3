// System calls that a sandbox has refused: a filter (seccomp) makes SIGSYS of them.
//
//   answerHarmlessCall   some belong to libraries, which do well without
//   describeCall         what a crash record says of the others
//
// Called within a signal handler.
#pragma once

#include "worker/protocol.h"

#include <signal.h>

namespace pathmark {

// Whether this is a signal of the filter.
bool isForbiddenCall(int signal, const siginfo_t& info);

// Makes the call return "no such file" and returns true, if a library has asked for a file that
// need not be there, such as those that tell how many processors the machine has.
bool answerHarmlessCall(const siginfo_t& info, void* context);

void describeCall(CrashRecord& record, const siginfo_t& info, const void* context);

}  // namespace pathmark
