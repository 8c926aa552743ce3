// Attack: reads a file through a folder that libraries may ask for
// Expected: forbidden call openat
#include <pathmark/coursework.h>

#include <fcntl.h>

namespace pathmark {

namespace {

int attack() {
  return open("/sys/../etc/passwd", O_RDONLY);
}

}  // namespace

}  // namespace pathmark
