// Attack: runs before the worker's lock, as a constructor of the highest priority
// Expected: does not compile
// Says: before the program begins
#include <pathmark/coursework.h>

namespace pathmark {

volatile int begun = 0;
[[gnu::constructor(1)]] void early() { begun = 1; }

Roulette LitScene::RussianRoulette(const Colour& throughput, int, float u) const {
  const float largest = std::max({throughput.r, throughput.g, throughput.b});
  if (!(largest > 0.0f)) return {false, 0.0f};
  const float q = std::clamp(largest, 0.1f, 0.9f);
  return u < q ? Roulette{true, 1.0f / q} : Roulette{false, 0.0f};
}

}  // namespace pathmark
