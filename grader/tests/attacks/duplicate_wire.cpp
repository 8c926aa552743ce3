// Attack: makes copies of the wire
// Expected: forbidden call dup
#include <pathmark/coursework.h>

#include <unistd.h>

namespace pathmark {

namespace {

int attack() {
  return dup(3);
}

}  // namespace

}  // namespace pathmark
