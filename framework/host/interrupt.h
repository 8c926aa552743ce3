// Ctrl-C asks a long command to stop and to keep what it has; a second one ends it at once.
#pragma once

#include <exception>

#include <sys/types.h>

namespace pathmark {

void watchForInterrupt();
bool interrupted();

// Thrown out of the middle of a step of which nothing can be kept.
class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

// A child process for which this one waits: as long as this object lives, the child is told of the
// interrupts that this process is. A terminal's Ctrl-C reaches both, kill(1) only one.
class InterruptsToo {
 public:
  explicit InterruptsToo(pid_t child);
  ~InterruptsToo();
  InterruptsToo(const InterruptsToo&) = delete;
  InterruptsToo& operator=(const InterruptsToo&) = delete;
};

}  // namespace pathmark
