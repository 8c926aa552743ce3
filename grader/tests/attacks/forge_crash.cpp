// Attack: writes a crash record of its own
// Expected: crashed or forbidden call
#include <pathmark/coursework.h>

#include <unistd.h>
#include <cstdlib>

namespace pathmark {

namespace {

int attack() {
  const unsigned record[512] = {0x48535243, 6, 0, 0xffffffff};
  [[maybe_unused]] const long n = write(4, record, sizeof record);
  std::abort();
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
