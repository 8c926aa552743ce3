// Attack: never ends
// Expected: time limit
// Says: part6_roulette.cpp:
#include <pathmark/coursework.h>

namespace pathmark {

namespace {

int attack() {
  for (volatile int x = 0; x < 1;) x = 0;
  return 0;
}

}  // namespace

}  // namespace pathmark
