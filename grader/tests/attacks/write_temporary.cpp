// Attack: leaves a file for the next submission
// Expected: forbidden call openat
#include <pathmark/coursework.h>

#include <fstream>

namespace pathmark {

namespace {

int attack() {
  std::ofstream("/tmp/pathmark-attack") << "left";
  return 0;
}

}  // namespace

}  // namespace pathmark
