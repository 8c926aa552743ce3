#include "host/worker_clock.h"

#include <cerrno>
#include <ctime>
#include <system_error>

namespace pathmark {

double cpuSecondsOf(pid_t process) {
  clockid_t clock{};
  timespec t{};
  // The first returns its error, the second leaves it in errno.
  if (const int error = clock_getcpuclockid(process, &clock);
      error != 0 || clock_gettime(clock, &t) != 0)
    throw std::system_error(error != 0 ? error : errno, std::generic_category(),
                            "asking for a worker's CPU time");
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace pathmark
