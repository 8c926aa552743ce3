// Attack: fills the shared memory
// Expected: forbidden call openat
#include <pathmark/coursework.h>

#include <fcntl.h>

namespace pathmark {

namespace {

int attack() {
  return open("/dev/shm/pathmark-attack", O_CREAT | O_RDWR, 0600);
}

}  // namespace

}  // namespace pathmark
