// Attack: follows no pointer
// Expected: crashed
// Says: SIGSEGV
#include <pathmark/coursework.h>

namespace pathmark {

namespace {

int attack() {
  volatile int* nothing = nullptr;
  return *nothing;
}

}  // namespace

}  // namespace pathmark
