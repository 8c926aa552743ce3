// A benchmark that was ended by Ctrl-C.
#pragma once

#include "host/interrupt.h"

namespace pathmark::bench {

inline void stopIfInterrupted() {
  if (interrupted()) throw Interrupted{};
}

}  // namespace pathmark::bench
