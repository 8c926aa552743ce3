// Attack: takes memory from the system without end
// Expected: crashed
#include <pathmark/coursework.h>

#include <sys/mman.h>

namespace pathmark {

namespace {

int attack() {
  for (;;) {
    void* more = mmap(nullptr, 1 << 24, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    *static_cast<volatile char*>(more) = 1;
  }
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
