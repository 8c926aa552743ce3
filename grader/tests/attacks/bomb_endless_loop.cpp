// Attack: never ends
// Verdict: time limit
#include <pathmark/coursework.h>

static void attack() {
  for (volatile int k = 0;; k = k + 1) {
  }
}
