// Stands in for part 6 where the path tracer is checked: it ends so many paths that a weight that
// is lost or counted twice shows at once.
#include <pathmark/coursework.h>

namespace pathmark {

Roulette LitScene::RussianRoulette(const Colour& throughput, int, float u) const {
  constexpr float kSurvival = 0.3f;
  if (throughput == Colour(0.0f) || u >= kSurvival) return {false, 0.0f};
  return {true, 1.0f / kSurvival};
}

}  // namespace pathmark
