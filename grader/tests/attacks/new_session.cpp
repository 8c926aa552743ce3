// Attack: leaves its group of processes
// Expected: forbidden call setsid
#include <pathmark/coursework.h>

#include <unistd.h>

namespace pathmark {

namespace {

int attack() {
  return setsid();
}

}  // namespace

}  // namespace pathmark
