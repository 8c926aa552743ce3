// Attack: reads the solution while it runs
// Expected: forbidden call openat
#include <pathmark/coursework.h>

#include <fstream>

namespace pathmark {

namespace {

int attack() {
  std::ifstream in("@ROOT@/solutions/part6_roulette.cpp");
  return in.get();
}

}  // namespace

}  // namespace pathmark
