// Attack: looks a name up
// Expected: forbidden call
#include <pathmark/coursework.h>

#include <netdb.h>

namespace pathmark {

namespace {

int attack() {
  addrinfo* found = nullptr;
  return getaddrinfo("example.org", "80", nullptr, &found);
}

}  // namespace

}  // namespace pathmark
