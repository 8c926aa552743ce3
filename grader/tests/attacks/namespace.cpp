// Attack: makes a user namespace
// Expected: forbidden call unshare
#include <pathmark/coursework.h>

#include <sched.h>

namespace pathmark {

namespace {

int attack() {
  return unshare(CLONE_NEWUSER);
}

}  // namespace

}  // namespace pathmark
