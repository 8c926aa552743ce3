// Part 6: Russian roulette. Handout: handouts/part6_roulette.md
#include <pathmark/coursework.h>

namespace pathmark {

// The first bounces carry most of the light and always go on. Later, what a path can still carry is
// bounded by its largest channel. Survival in proportion to it would give all paths that go on the
// same weight, but the rays that this saves cost more in noise: paths that carry half as much as at
// first are worth going on with for certain, and only below that the probability falls.
Roulette LitScene::RussianRoulette(const Colour& throughput, int depth, float u) const {
  constexpr int kFirstDepth = 4;
  const float largest = std::max({throughput.r, throughput.g, throughput.b});
  if (!(largest > 0.0f)) return {false, 0.0f};
  const float q = depth < kFirstDepth ? 1.0f : std::clamp(2.0f * largest, 0.05f, 0.95f);
  if (u >= q) return {false, 0.0f};
  return {true, 1.0f / q};
}

}  // namespace pathmark
