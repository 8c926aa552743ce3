// Attack: catches the signal of refused calls
// Expected: forbidden call rt_sigaction
#include <pathmark/coursework.h>

#include <signal.h>

namespace pathmark {

namespace {

int attack() {
  return signal(SIGSYS, SIG_IGN) == SIG_ERR;
}

}  // namespace

}  // namespace pathmark
