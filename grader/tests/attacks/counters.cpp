// Attack: watches the machine
// Expected: forbidden call perf_event_open
#include <pathmark/coursework.h>

#include <unistd.h>
#include <sys/syscall.h>

namespace pathmark {

namespace {

int attack() {
  return static_cast<int>(syscall(SYS_perf_event_open, nullptr, 0, -1, -1, 0));
}

}  // namespace

}  // namespace pathmark
