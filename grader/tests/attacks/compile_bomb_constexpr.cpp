// Attack: the compiler is to compute without end
// Verdict: does not compile
#include <pathmark/coursework.h>

constexpr long count(long n) { return n == 0 ? 0 : count(n - 1) + count(n - 1); }
static void attack() {
  volatile long x = count(400);
  constexpr long y = count(45);
  x = y;
}
