// Attack: wants to survive its own crash
// Verdict: crashed, time limit, wrong
#include <pathmark/coursework.h>

#include <csignal>
static void attack() {
  for (int signal = 1; signal < 32; ++signal) std::signal(signal, SIG_IGN);
  *static_cast<volatile int*>(nullptr) = 1;
}
