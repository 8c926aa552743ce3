// Attack: reads the host's memory through /proc
// Expected: forbidden call openat
#include <pathmark/coursework.h>

#include <fstream>

namespace pathmark {

namespace {

int attack() {
  std::ifstream in("/proc/@HOST@/maps");
  return in.get();
}

}  // namespace

}  // namespace pathmark
