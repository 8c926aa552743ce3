// Attack: prints without end
// Expected: output limit
#include <pathmark/coursework.h>

#include <cstdio>

namespace pathmark {

namespace {

int attack() {
  for (;;) std::puts("all tests passed, all tests passed, all tests passed");
}

}  // namespace

}  // namespace pathmark
