// Attack: makes a link
// Expected: forbidden call symlink
#include <pathmark/coursework.h>

#include <unistd.h>

namespace pathmark {

namespace {

int attack() {
  return symlink("/etc/passwd", "@CANARY@/link");
}

}  // namespace

}  // namespace pathmark
