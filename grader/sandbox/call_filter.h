// Filters of system calls (seccomp), as programs for the kernel.
//
//   workerFilter   of programs that hold coursework: threads and memory, and no more
//   toolFilter     of compilers and linkers: files and processes too
#pragma once

#include <cstdint>
#include <vector>

#include <linux/filter.h>

namespace pathmark::sandbox {

using CallFilter = std::vector<sock_filter>;

// Stands in a filter where the number of the process is to be put in.
inline constexpr std::uint32_t kOwnProcess = 0x7fffff01;

// A call that is not allowed ends the worker with SIGSYS, which its crash handler reports. With
// `ownSignalsOnly` the filter has kOwnProcess in it. Both throw std::system_error.
CallFilter workerFilter(bool ownSignalsOnly);

// A call that is not allowed fails with EPERM.
CallFilter toolFilter();

}  // namespace pathmark::sandbox
