// Attack: never ends before the program has begun
// Verdict: time limit
#include <pathmark/coursework.h>

static int never() {
  for (volatile int k = 0;; k = k + 1) {
  }
}
static const int early = never();
static void attack() { volatile int x = early; }
