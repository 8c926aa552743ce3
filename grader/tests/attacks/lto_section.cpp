// Attack: smuggles code for the linker's plug-in into its object
// Expected: does not compile
// Says: link-time optimisation
#include <pathmark/coursework.h>

namespace pathmark {

asm(".section .gnu.lto_main,\"e\"\n.byte 1\n.text");

Roulette LitScene::RussianRoulette(const Colour& throughput, int, float u) const {
  const float largest = std::max({throughput.r, throughput.g, throughput.b});
  if (!(largest > 0.0f)) return {false, 0.0f};
  const float q = std::clamp(largest, 0.1f, 0.9f);
  return u < q ? Roulette{true, 1.0f / q} : Roulette{false, 0.0f};
}

}  // namespace pathmark
