// Attack: changes its root
// Expected: forbidden call chroot
#include <pathmark/coursework.h>

#include <unistd.h>

namespace pathmark {

namespace {

int attack() {
  return chroot("/tmp");
}

}  // namespace

}  // namespace pathmark
