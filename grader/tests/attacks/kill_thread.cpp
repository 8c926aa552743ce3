// Attack: sends a signal to a thread of the host
// Expected: forbidden call tgkill
#include <pathmark/coursework.h>

#include <signal.h>
#include <unistd.h>
#include <sys/syscall.h>

namespace pathmark {

namespace {

int attack() {
  return static_cast<int>(syscall(SYS_tgkill, @HOST@, @HOST@, SIGABRT));
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
