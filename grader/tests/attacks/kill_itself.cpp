// Attack: kills itself, to look like a lack of memory
// Expected: forbidden call tgkill
#include <pathmark/coursework.h>

#include <signal.h>

namespace pathmark {

namespace {

int attack() {
  return raise(SIGKILL);
}

}  // namespace

}  // namespace pathmark
