// Attack: never ends, and does not listen when it is asked where it is
// Verdict: time limit
#include <pathmark/coursework.h>

#include <csignal>
static void attack() {
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, nullptr);
  for (volatile int k = 0;; k = k + 1) {
  }
}
