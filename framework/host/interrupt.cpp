#include "host/interrupt.h"

#include <csignal>

namespace pathmark {

namespace {

// A signal handler can reach nothing else.
volatile std::sig_atomic_t interruptSeen = 0;

void onInterrupt(int signal) {
  interruptSeen = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void watchForInterrupt() {
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
}

bool interrupted() { return interruptSeen != 0; }

}  // namespace pathmark
