// Attack: handles its own page faults
// Expected: forbidden call userfaultfd
#include <pathmark/coursework.h>

#include <unistd.h>
#include <sys/syscall.h>

namespace pathmark {

namespace {

int attack() {
  return static_cast<int>(syscall(SYS_userfaultfd, 0));
}

}  // namespace

}  // namespace pathmark
