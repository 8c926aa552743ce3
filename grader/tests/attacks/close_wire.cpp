// Attack: closes the wire and goes on
// Expected: crashed
#include <pathmark/coursework.h>

#include <unistd.h>

namespace pathmark {

namespace {

int attack() {
  for (int fd = 0; fd < 64; ++fd) close(fd);
  for (volatile int x = 0; x < 1;) x = 0;
  return 0;
}

}  // namespace

}  // namespace pathmark
