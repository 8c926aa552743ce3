// Attack: ends the program
// Expected: crashed
// Says: part6_roulette.cpp:
#include <pathmark/coursework.h>

#include <cstdlib>

namespace pathmark {

namespace {

int attack() {
  std::exit(0);
}

}  // namespace

}  // namespace pathmark
