// Attack: speaks to services of the machine
// Expected: forbidden call socket
#include <pathmark/coursework.h>

#include <sys/socket.h>

namespace pathmark {

namespace {

int attack() {
  return socket(AF_UNIX, SOCK_STREAM, 0);
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
