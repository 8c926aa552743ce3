// Attack: reads the environment of the process
// Expected: forbidden call openat
#include <pathmark/coursework.h>

#include <fstream>

namespace pathmark {

namespace {

int attack() {
  std::ifstream in("/proc/self/environ");
  return in.get();
}

}  // namespace

}  // namespace pathmark
