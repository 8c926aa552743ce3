// Attack: starts threads without end
// Expected: crashed
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

Roulette LitScene::RussianRoulette(const Colour& throughput, int, float u) const {
  static const int done = attack();
  (void)done;
  const float largest = std::max({throughput.r, throughput.g, throughput.b});
  if (!(largest > 0.0f)) return {false, 0.0f};
  const float q = std::clamp(largest, 0.1f, 0.9f);
  return u < q ? Roulette{true, 1.0f / q} : Roulette{false, 0.0f};
}

}  // namespace pathmark
