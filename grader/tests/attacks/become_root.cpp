// Attack: becomes root
// Expected: forbidden call setuid
#include <pathmark/coursework.h>

#include <unistd.h>
#include <sys/syscall.h>

namespace pathmark {

namespace {

int attack() {
  return static_cast<int>(syscall(SYS_setuid, 0));
}

}  // namespace

}  // namespace pathmark
