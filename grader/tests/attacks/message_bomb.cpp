// Attack: makes the compiler print without end
// Expected: ok
#if __INCLUDE_LEVEL__ < 13
#pragma message "again, and again, and again, and again, and again, and again, and again, and again"
#include "part6_roulette.cpp"
#pragma message "again, and again, and again, and again, and again, and again, and again, and again"
#if __INCLUDE_LEVEL__ < 12
#include "part6_roulette.cpp"
#endif
#endif
#if __INCLUDE_LEVEL__ == 0
#include <pathmark/coursework.h>

namespace pathmark {

Roulette LitScene::RussianRoulette(const Colour& throughput, int, float u) const {
  const float largest = std::max({throughput.r, throughput.g, throughput.b});
  if (!(largest > 0.0f)) return {false, 0.0f};
  const float q = std::clamp(largest, 0.1f, 0.9f);
  return u < q ? Roulette{true, 1.0f / q} : Roulette{false, 0.0f};
}

}  // namespace pathmark
#endif
