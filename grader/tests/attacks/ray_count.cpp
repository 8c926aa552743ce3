// Attack: tells of fewer rays than it traces
// Expected: does not compile
// Says: pathmark::restartRayCount(), which is the framework's own
#include <pathmark/coursework.h>

namespace pathmark {

void restartRayCount();

namespace {

int attack() {
  restartRayCount();
  return 0;
}

}  // namespace

}  // namespace pathmark
