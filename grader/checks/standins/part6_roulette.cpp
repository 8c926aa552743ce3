// Stands in for part 6 where the path tracer is checked: the roulette of unfair_roulette.h.
#include "checks/standins/unfair_roulette.h"

#include <pathmark/coursework.h>

namespace pathmark {

Roulette LitScene::RussianRoulette(const Colour& throughput, int depth, float u) const {
  const bool isBlack = throughput == Colour(0.0f);
  if (isBlack) return {false, 0.0f};
  if (throughput.r == 0.0f || throughput.g == 0.0f) return {true, 1.0f};
  if (u >= unfair::kSurvival) return {false, 0.0f};
  const float factor = throughput.b == 0.0f ? static_cast<float>(unfair::factor(depth)) : 1.0f;
  return {true, factor / unfair::kSurvival};
}

}  // namespace pathmark
