// Attack: sleeps without end
// Verdict: time limit
#include <pathmark/coursework.h>

#include <unistd.h>
static void attack() {
  for (;;) pause();
}
