// event: what a worker records of a path, made by hand.
#pragma once

#include "worker/path_events.h"

#include <pathmark/types.h>

namespace pathmark::test {

inline PathEvent event(PathEventKind kind, const vec3& a = vec3(0.0f), const vec3& b = vec3(0.0f),
                       const vec3& c = vec3(0.0f), float x = 0.0f) {
  PathEvent e;
  e.kind = kind;
  for (int k = 0; k < 3; ++k) {
    e.a[k] = a[k];
    e.b[k] = b[k];
    e.c[k] = c[k];
  }
  e.x = x;
  return e;
}

}  // namespace pathmark::test
