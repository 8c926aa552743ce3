// Attack: makes an object that fills the disk after some submissions
// Expected: does not compile
// Says: the object file has 9 MiB, and at most 4 are allowed
#include <pathmark/coursework.h>

namespace pathmark {

char large[std::size_t{8} << 20] = {1};

Roulette LitScene::RussianRoulette(const Colour& throughput, int, float u) const {
  const float largest = std::max({throughput.r, throughput.g, throughput.b});
  if (!(largest > 0.0f)) return {false, 0.0f};
  const float q = std::clamp(largest, 0.1f, 0.9f);
  return u < q ? Roulette{true, 1.0f / q} : Roulette{false, 0.0f};
}

}  // namespace pathmark
