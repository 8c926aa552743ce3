// Attack: never ends, with all signals blocked
// Expected: time limit
#include <pathmark/coursework.h>

#include <signal.h>

namespace pathmark {

namespace {

int attack() {
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, nullptr);
  for (volatile int x = 0; x < 1;) x = 0;
  return 0;
}

}  // namespace

}  // namespace pathmark
