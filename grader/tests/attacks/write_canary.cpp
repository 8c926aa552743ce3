// Attack: overwrites a file of the machine
// Expected: forbidden call openat
#include <pathmark/coursework.h>

#include <fstream>

namespace pathmark {

namespace {

int attack() {
  std::ofstream("@CANARY@/canary") << "overwritten";
  return 0;
}

}  // namespace

}  // namespace pathmark
