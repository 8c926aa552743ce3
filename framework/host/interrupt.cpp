#include "host/interrupt.h"

#include <atomic>
#include <cerrno>
#include <csignal>

#include <time.h>

namespace pathmark {

namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM};

// A signal handler can reach nothing else.
volatile std::sig_atomic_t interruptSeen = 0;
timespec firstSeen;
std::atomic<pid_t> toldToo{0};  // 0: nobody
static_assert(std::atomic<pid_t>::is_always_lock_free);

double secondsSinceFirst() {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec - firstSeen.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec - firstSeen.tv_nsec);
}

// One interrupt may arrive twice at once: timeout(1) tells the process and then its group.
constexpr double kOneInterrupt = 0.1;

void onInterrupt(int signal) {
  const int error = errno;
  if (const pid_t child = toldToo.load(); child > 0) kill(child, signal);
  errno = error;
  if (interruptSeen == 0) {
    clock_gettime(CLOCK_MONOTONIC, &firstSeen);
    interruptSeen = 1;
  } else if (secondsSinceFirst() > kOneInterrupt) {
    std::signal(signal, SIG_DFL);
    raise(signal);
  }
}

}  // namespace

void watchForInterrupt() {
  // Neither handler runs within the other.
  struct sigaction action = {};
  action.sa_handler = onInterrupt;
  action.sa_flags = SA_RESTART;
  for (const int signal : kSignals) sigaddset(&action.sa_mask, signal);
  for (const int signal : kSignals) sigaction(signal, &action, nullptr);
  // A file that has become too large is an error of the one who writes it, not the end.
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() { return interruptSeen != 0; }

InterruptsToo::InterruptsToo(pid_t child) {
  toldToo.store(child);
  if (interrupted()) kill(child, SIGTERM);
}

InterruptsToo::~InterruptsToo() { toldToo.store(0); }

}  // namespace pathmark
