// Attack: renames a file of the machine
// Expected: forbidden call rename
#include <pathmark/coursework.h>

#include <cstdio>

namespace pathmark {

namespace {

int attack() {
  return std::rename("@CANARY@/canary", "@CANARY@/moved");
}

}  // namespace

}  // namespace pathmark
