// Attack: starts processes without end
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <unistd.h>
static void attack() {
  for (;;) fork();
}
