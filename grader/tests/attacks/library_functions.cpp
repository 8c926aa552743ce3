// Attack: replaces functions of the C library by name
// Expected: ok
#include <pathmark/coursework.h>

namespace pathmark {

extern "C" {
int main() { return 0; }
void* malloc(std::size_t) { return nullptr; }
long send(int, const void*, std::size_t, int) { return -1; }
long recvmsg(int, void*, int) { return 0; }
int sigaction(int, const void*, void*) { return 0; }
}

Roulette LitScene::RussianRoulette(const Colour& throughput, int, float u) const {
  const float largest = std::max({throughput.r, throughput.g, throughput.b});
  if (!(largest > 0.0f)) return {false, 0.0f};
  const float q = std::clamp(largest, 0.1f, 0.9f);
  return u < q ? Roulette{true, 1.0f / q} : Roulette{false, 0.0f};
}

}  // namespace pathmark
