// Attack: mounts
// Expected: forbidden call mount
#include <pathmark/coursework.h>

#include <sys/mount.h>

namespace pathmark {

namespace {

int attack() {
  return mount("none", "/tmp", "tmpfs", 0, nullptr);
}

}  // namespace

}  // namespace pathmark
