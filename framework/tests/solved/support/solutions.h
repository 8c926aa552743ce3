// solutions: the solved coursework, compiled once for all tests of a program.
#pragma once

#include "host/session.h"

namespace pathmark::test {

inline const Coursework& solutions() {
  static const Coursework coursework = prepareCoursework("solutions");
  return coursework;
}

}  // namespace pathmark::test
