// Attack: prints errors without end
// Expected: output limit
#include <pathmark/coursework.h>

#include <iostream>

namespace pathmark {

namespace {

int attack() {
  for (;;) std::cerr << "all tests passed, all tests passed" << std::endl;
}

}  // namespace

}  // namespace pathmark
