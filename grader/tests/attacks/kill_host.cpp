// Attack: kills the host
// Expected: forbidden call kill
#include <pathmark/coursework.h>

#include <signal.h>

namespace pathmark {

namespace {

int attack() {
  return kill(@HOST@, SIGKILL);
}

}  // namespace

}  // namespace pathmark
