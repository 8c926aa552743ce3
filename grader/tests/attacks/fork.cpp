// Attack: starts a process
// Expected: forbidden call clone
// Says: part6_roulette.cpp:
#include <pathmark/coursework.h>

#include <unistd.h>

namespace pathmark {

namespace {

int attack() {
  return fork();
}

}  // namespace

}  // namespace pathmark
