// Attack: calls home
// Expected: forbidden call socket
#include <pathmark/coursework.h>

#include <netinet/in.h>
#include <sys/socket.h>

namespace pathmark {

namespace {

int attack() {
  return socket(AF_INET, SOCK_STREAM, 0);
}

}  // namespace

}  // namespace pathmark
