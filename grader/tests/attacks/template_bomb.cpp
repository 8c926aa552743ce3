// Attack: keeps the compiler busy with templates
// Expected: does not compile
#include <pathmark/coursework.h>

namespace pathmark {

template <int N, int M>
struct Bomb {
  static constexpr int x = Bomb<N - 1, 2 * M>::x + Bomb<N - 1, 2 * M + 1>::x;
};
template <int M>
struct Bomb<0, M> {
  static constexpr int x = M;
};
int all = Bomb<24, 1>::x;

Roulette LitScene::RussianRoulette(const Colour& throughput, int, float u) const {
  const float largest = std::max({throughput.r, throughput.g, throughput.b});
  if (!(largest > 0.0f)) return {false, 0.0f};
  const float q = std::clamp(largest, 0.1f, 0.9f);
  return u < q ? Roulette{true, 1.0f / q} : Roulette{false, 0.0f};
}

}  // namespace pathmark
