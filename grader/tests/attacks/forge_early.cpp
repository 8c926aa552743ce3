// Attack: answers in the worker's place
// Expected: crashed
#include <pathmark/coursework.h>

#include <unistd.h>

namespace pathmark {

namespace {

int attack() {
  const unsigned hello[] = {0x31574d50, 1, 0, 0, 8, 0, 7, 0};
  return static_cast<int>(write(3, hello, sizeof hello));
}

const int done = attack();

}  // namespace

Roulette LitScene::RussianRoulette(const Colour& throughput, int, float u) const {
  const float largest = std::max({throughput.r, throughput.g, throughput.b});
  if (!(largest > 0.0f)) return {false, 0.0f};
  const float q = std::clamp(largest, 0.1f, 0.9f);
  return u < q ? Roulette{true, 1.0f / q} : Roulette{false, 0.0f};
}

}  // namespace pathmark
