// Attack: aborts
// Expected: crashed
// Says: SIGABRT
#include <pathmark/coursework.h>

#include <cstdlib>

namespace pathmark {

namespace {

int attack() {
  std::abort();
}

}  // namespace

}  // namespace pathmark
