// Attack: reads the list of users with a stream
// Expected: forbidden call openat
// Says: /etc/passwd
#include <pathmark/coursework.h>

#include <fstream>

namespace pathmark {

namespace {

int attack() {
  std::ifstream in("/etc/passwd");
  return in.get();
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
