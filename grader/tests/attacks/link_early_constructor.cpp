// Attack: the first constructor of all says that all is well, and ends the program
// Verdict: crashed
#include <pathmark/coursework.h>

#include <unistd.h>
#include <cstdio>
__attribute__((constructor(1))) static void leave() {
  std::puts("all passed");
  std::fflush(stdout);
  _exit(0);
}
static void attack() {}
