// Attack: types into the terminal
// Expected: forbidden call ioctl
#include <pathmark/coursework.h>

#include <sys/ioctl.h>
#include <termios.h>

namespace pathmark {

namespace {

int attack() {
  char letter = 33;
  return ioctl(1, TIOCSTI, &letter);
}

}  // namespace

}  // namespace pathmark
