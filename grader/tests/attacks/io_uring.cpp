// Attack: makes calls through a ring
// Expected: forbidden call io_uring_setup
#include <pathmark/coursework.h>

#include <unistd.h>
#include <sys/syscall.h>

namespace pathmark {

namespace {

int attack() {
  char parameters[256] = {};
  return static_cast<int>(syscall(SYS_io_uring_setup, 1, parameters));
}

}  // namespace

}  // namespace pathmark
