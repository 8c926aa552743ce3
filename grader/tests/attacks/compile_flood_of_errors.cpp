// Attack: the compiler is to print without end
// Verdict: does not compile
#include <pathmark/coursework.h>

#define X10(x) x x x x x x x x x x
#define X1000(x) X10(X10(X10(x)))
X1000(X1000(int a = nonsense;))
static void attack() {}
