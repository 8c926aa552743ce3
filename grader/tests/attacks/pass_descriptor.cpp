// Attack: sends the host a descriptor
// Expected: forbidden call sendmsg
#include <pathmark/coursework.h>

#include <sys/socket.h>

namespace pathmark {

namespace {

int attack() {
  msghdr message{};
  return static_cast<int>(sendmsg(3, &message, 0));
}

}  // namespace

}  // namespace pathmark
