// Attack: writes to the framework's code through /proc
// Expected: forbidden call openat
#include <pathmark/coursework.h>

#include <fcntl.h>

namespace pathmark {

namespace {

int attack() {
  return open("/proc/self/mem", O_RDWR);
}

}  // namespace

}  // namespace pathmark
