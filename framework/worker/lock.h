// The worker's own lock, inside whatever sandbox it runs in: from here on coursework may run.
//
// It is there for the report more than for safety, which is the sandbox's: what a worker needs
// while it starts (opening libraries, being executed) the sandbox must allow, and would only find
// nothing there. With the lock such a call is reported with its function and line.
#pragma once

namespace pathmark {

// Returns whether the lock holds; for the whole process, and for good. First uses what could not
// start behind it.
bool lockWorker();

}  // namespace pathmark
