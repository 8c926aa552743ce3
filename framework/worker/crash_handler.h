// Reports the death of a worker: which signal, and where.
#pragma once

namespace pathmark {

// For the whole process: fatal signals, uncaught exceptions, and SIGUSR1 ("where are you?").
void installCrashHandlers();

// For the calling thread: a stack of its own for signal handlers, without which a stack overflow
// could not be reported, and the bounds by which one is recognised.
void prepareThreadForCrashes();

}  // namespace pathmark
