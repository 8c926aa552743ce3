// Attack: starts processes without end
// Expected: forbidden call clone
#include <pathmark/coursework.h>

#include <unistd.h>

namespace pathmark {

namespace {

int attack() {
  for (;;) fork();
}

}  // namespace

}  // namespace pathmark
