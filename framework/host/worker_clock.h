// cpuSecondsOf: the time that a process of ours has had on processors.
#pragma once

#include <sys/types.h>

namespace pathmark {

// Throws std::system_error.
double cpuSecondsOf(pid_t process);

}  // namespace pathmark
