// Attack: sleeps
// Expected: time limit
#include <pathmark/coursework.h>

#include <unistd.h>

namespace pathmark {

namespace {

int attack() {
  return static_cast<int>(sleep(100000));
}

}  // namespace

}  // namespace pathmark
