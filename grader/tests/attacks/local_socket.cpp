// Attack: speaks to services of the machine
// Expected: forbidden call socket
#include <pathmark/coursework.h>

#include <sys/socket.h>

namespace pathmark {

namespace {

int attack() {
  return socket(AF_UNIX, SOCK_STREAM, 0);
}

}  // namespace

}  // namespace pathmark
