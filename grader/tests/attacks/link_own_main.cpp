// Attack: a main of its own that says that all is well
// Verdict: ok
#include <pathmark/coursework.h>

#include <cstdio>
int main() {
  std::puts("all passed");
  return 0;
}
static void attack() {}
