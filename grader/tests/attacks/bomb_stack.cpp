// Attack: calls itself without end
// Verdict: crashed
#include <pathmark/coursework.h>

static int deeper(volatile int* x) {
  volatile int y[1024];
  y[0] = *x + 1;
  return deeper(y) + y[7];
}
static void attack() {
  volatile int x = 0;
  deeper(&x);
}
