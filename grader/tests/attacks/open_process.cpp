// Attack: opens a handle of the host
// Expected: forbidden call pidfd_open
#include <pathmark/coursework.h>

#include <unistd.h>
#include <sys/syscall.h>

namespace pathmark {

namespace {

int attack() {
  return static_cast<int>(syscall(SYS_pidfd_open, @HOST@, 0));
}

}  // namespace

}  // namespace pathmark
