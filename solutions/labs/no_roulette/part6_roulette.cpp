// Lab: no roulette. Handout: handouts/labs.md
#include <pathmark/coursework.h>

namespace pathmark {

// Every path goes on until maxBounces(), unless it carries nothing.
Roulette LitScene::RussianRoulette(const Colour& throughput, int, float) const {
  return {throughput != Colour(0.0f), 1.0f};
}

}  // namespace pathmark
