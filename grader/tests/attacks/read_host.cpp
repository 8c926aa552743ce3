// Attack: reads the host's memory
// Expected: forbidden call process_vm_readv
#include <pathmark/coursework.h>

#include <sys/uio.h>

namespace pathmark {

namespace {

int attack() {
  char byte = 0;
  iovec here{&byte, 1}, there{reinterpret_cast<void*>(0x400000), 1};
  return static_cast<int>(process_vm_readv(@HOST@, &here, 1, &there, 1, 0));
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
