// Attack: makes a process in a new namespace
// Expected: forbidden call clone
#include <pathmark/coursework.h>

#include <sched.h>
#include <signal.h>
#include <unistd.h>
#include <sys/syscall.h>

namespace pathmark {

namespace {

int attack() {
  return static_cast<int>(syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, nullptr, nullptr, nullptr, 0));
}

}  // namespace

}  // namespace pathmark
