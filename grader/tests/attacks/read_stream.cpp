// Attack: reads the list of users with a stream
// Expected: forbidden call openat
// Says: /etc/passwd
#include <pathmark/coursework.h>

#include <fstream>

namespace pathmark {

namespace {

int attack() {
  std::ifstream in("/etc/passwd");
  return in.get();
}

}  // namespace

}  // namespace pathmark
