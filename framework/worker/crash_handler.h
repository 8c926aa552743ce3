// Reports the death of a worker: which signal, and where.
//
// The handlers for the process (fatal signals, uncaught exceptions, exit(), and SIGUSR1, "where
// are you?") install themselves before the program's own constructors run.
#pragma once

namespace pathmark {

// For the calling thread: a stack of its own for signal handlers, without which a stack overflow
// could not be reported, and the bounds by which one is recognised.
void prepareThreadForCrashes();

// exit() in up to `threads` threads at once is reported before anything is destroyed. The C library
// takes each registered function off its list when a thread calls it, so that every thread needs
// one of its own: a thread that found none would end the process while another still reports.
void reportExits(int threads);

// From here on the end of the program is meant.
void finishWorker();

}  // namespace pathmark
