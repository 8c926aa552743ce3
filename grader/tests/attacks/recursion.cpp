// Attack: recurses without end
// Expected: crashed
// Says: stack overflow
#include <pathmark/coursework.h>

namespace pathmark {

namespace {

int attack() {
  volatile int x = 0;
  return attack() + x;
}

}  // namespace

}  // namespace pathmark
