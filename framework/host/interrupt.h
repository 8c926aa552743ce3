// Ctrl-C asks a long command to stop and to keep what it has; a second one ends it at once.
#pragma once

namespace pathmark {

void watchForInterrupt();
bool interrupted();

}  // namespace pathmark
