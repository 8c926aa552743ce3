// Attack: ends with the code of a signal
// Expected: crashed
// Says: exit() was called
#include <pathmark/coursework.h>

#include <cstdlib>

namespace pathmark {

namespace {

int attack() {
  std::_Exit(137);
}

}  // namespace

}  // namespace pathmark
