// Attack: starts threads without end
// Expected: crashed or time limit
#include <pathmark/coursework.h>

#include <pthread.h>
#include <unistd.h>

namespace pathmark {

namespace {

int attack() {
  pthread_attr_t small;
  pthread_attr_init(&small);
  pthread_attr_setstacksize(&small, 1 << 14);
  const auto wait = [](void*) -> void* {
    for (;;) pause();
  };
  for (pthread_t thread; pthread_create(&thread, &small, wait, nullptr) == 0;) {
  }
  __builtin_trap();
}

}  // namespace

}  // namespace pathmark
