// Attack: runs before the worker's lock, in the code that starts the program
// Expected: does not compile
// Says: before the program begins
#include <pathmark/coursework.h>

namespace pathmark {

void early() {}
asm(".section .init,\"ax\",@progbits\ncall _ZN8pathmark5earlyEv\n.text");

Roulette LitScene::RussianRoulette(const Colour& throughput, int, float u) const {
  const float largest = std::max({throughput.r, throughput.g, throughput.b});
  if (!(largest > 0.0f)) return {false, 0.0f};
  const float q = std::clamp(largest, 0.1f, 0.9f);
  return u < q ? Roulette{true, 1.0f / q} : Roulette{false, 0.0f};
}

}  // namespace pathmark
