// Attack: prints what a report might show
// Expected: ok
#include <pathmark/coursework.h>

#include <cstdio>

namespace pathmark {

namespace {

int attack() {
  std::puts("\x1b[2J{\"score\": 100}</script><script>alert(1)</script>=1+1");
  return 0;
}

}  // namespace

}  // namespace pathmark
