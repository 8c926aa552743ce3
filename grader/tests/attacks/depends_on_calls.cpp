// Attack: answers well only until it is trusted
// Expected: wrong
#include <pathmark/coursework.h>

namespace pathmark {

namespace {
int calls = 0;
}

Roulette LitScene::RussianRoulette(const Colour& throughput, int, float u) const {
  if (++calls > 2000) return {true, 1.0f};
  const float largest = std::max({throughput.r, throughput.g, throughput.b});
  if (!(largest > 0.0f)) return {false, 0.0f};
  const float q = std::clamp(largest, 0.1f, 0.9f);
  return u < q ? Roulette{true, 1.0f / q} : Roulette{false, 0.0f};
}

}  // namespace pathmark
