// Attack: lays another filter over the lock
// Expected: forbidden call seccomp
#include <pathmark/coursework.h>

#include <unistd.h>
#include <sys/syscall.h>

namespace pathmark {

namespace {

int attack() {
  return static_cast<int>(syscall(SYS_seccomp, 0, 0, nullptr));
}

}  // namespace

}  // namespace pathmark
