// Attack: prints the environment
// Expected: ok
#include <pathmark/coursework.h>

#include <cstdio>
#include <unistd.h>

namespace pathmark {

namespace {

int attack() {
  for (char** variable = environ; *variable; ++variable) std::puts(*variable);
  return 0;
}

}  // namespace

}  // namespace pathmark
