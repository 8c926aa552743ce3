// Attack: reads a file without the C library
// Expected: forbidden call open
#include <pathmark/coursework.h>

#include <sys/syscall.h>

namespace pathmark {

namespace {

int attack() {
  long result = SYS_open;
  asm volatile("syscall" : "+a"(result) : "D"("/etc/passwd"), "S"(0L), "d"(0L) : "rcx", "r11", "memory");
  return static_cast<int>(result);
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
