// Attack: runs a shell
// Expected: forbidden call
// Says: SIGSYS
#include <pathmark/coursework.h>

#include <cstdlib>

namespace pathmark {

namespace {

int attack() {
  return std::system("echo attacked > @CANARY@/canary");
}

}  // namespace

}  // namespace pathmark
