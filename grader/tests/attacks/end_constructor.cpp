// Attack: says that all is well before the program begins, and ends it
// Verdict: crashed
#include <pathmark/coursework.h>

#include <cstdio>
#include <cstdlib>
struct Early {
  Early() {
    std::puts("[  PASSED  ] all tests.");
    std::exit(0);
  }
};
static const Early early;
static void attack() {}
