// Attack: takes memory without end
// Expected: memory limit
#include <pathmark/coursework.h>

#include <vector>

namespace pathmark {

namespace {

int attack() {
  std::vector<std::vector<char>> all;
  for (;;) all.emplace_back(std::size_t{1} << 24, 1);
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
