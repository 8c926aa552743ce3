// Attack: survives its parent
// Expected: forbidden call prctl
#include <pathmark/coursework.h>

#include <sys/prctl.h>

namespace pathmark {

namespace {

int attack() {
  return prctl(PR_SET_PDEATHSIG, 0);
}

}  // namespace

}  // namespace pathmark
