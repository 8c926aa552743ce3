// Attack: starts threads without end
// Verdict: crashed, memory limit, time limit, forbidden call
#include <pathmark/coursework.h>

#include <unistd.h>
#include <thread>
static void attack() {
  for (;;) std::thread([] { pause(); }).detach();
}
