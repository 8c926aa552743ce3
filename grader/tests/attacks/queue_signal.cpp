// Attack: queues a signal for the host
// Expected: forbidden call rt_sigqueueinfo
#include <pathmark/coursework.h>

#include <signal.h>

namespace pathmark {

namespace {

int attack() {
  return sigqueue(@HOST@, SIGTERM, {});
}

}  // namespace

}  // namespace pathmark
