// Attack: sends a signal to a thread of the host
// Expected: forbidden call tgkill
#include <pathmark/coursework.h>

#include <signal.h>
#include <unistd.h>
#include <sys/syscall.h>

namespace pathmark {

namespace {

int attack() {
  return static_cast<int>(syscall(SYS_tgkill, @HOST@, @HOST@, SIGABRT));
}

}  // namespace

}  // namespace pathmark
