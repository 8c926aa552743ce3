// Attack: prints without end
// Verdict: output limit
#include <pathmark/coursework.h>

#include <cstdio>
static void attack() {
  for (;;) std::puts("all passed all passed all passed all passed all passed all passed");
}
