// Attack: becomes another program
// Expected: forbidden call execve
// Says: /bin/sh
#include <pathmark/coursework.h>

#include <unistd.h>

namespace pathmark {

namespace {

int attack() {
  return execl("/bin/sh", "sh", "-c", "sleep 100", nullptr);
}

}  // namespace

}  // namespace pathmark
