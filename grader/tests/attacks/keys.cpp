// Attack: reads the keys of the kernel
// Expected: forbidden call keyctl
#include <pathmark/coursework.h>

#include <unistd.h>
#include <sys/syscall.h>

namespace pathmark {

namespace {

int attack() {
  return static_cast<int>(syscall(SYS_keyctl, 0, -3, 0));
}

}  // namespace

}  // namespace pathmark
