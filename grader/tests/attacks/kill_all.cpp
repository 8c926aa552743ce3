// Attack: kills every process
// Expected: forbidden call kill
#include <pathmark/coursework.h>

#include <signal.h>

namespace pathmark {

namespace {

int attack() {
  return kill(-1, SIGKILL);
}

}  // namespace

}  // namespace pathmark
