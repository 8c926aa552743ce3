// Attack: speaks to the machine below
// Expected: forbidden call socket
#include <pathmark/coursework.h>

#include <sys/socket.h>

namespace pathmark {

namespace {

int attack() {
  return socket(AF_VSOCK, SOCK_STREAM, 0);
}

}  // namespace

}  // namespace pathmark
