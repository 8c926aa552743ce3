// Attack: starts a process
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <unistd.h>
static void attack() {
  if (fork() == 0) _exit(0);
}
