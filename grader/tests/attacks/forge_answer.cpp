// Attack: writes answers of its own to the wire
// Expected: crashed
// Says: does not fit the question
#include <pathmark/coursework.h>

#include <unistd.h>

namespace pathmark {

namespace {

int attack() {
  char zeros[64] = {};
  return static_cast<int>(write(3, zeros, sizeof zeros));
}

}  // namespace

}  // namespace pathmark
