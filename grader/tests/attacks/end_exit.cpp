// Attack: ends well
// Verdict: crashed
#include <pathmark/coursework.h>

#include <cstdio>
#include <cstdlib>
static void attack() {
  std::puts("all passed");
  std::exit(0);
}
