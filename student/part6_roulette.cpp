// Part 6: Russian roulette. Handout: handouts/part6_roulette.md
#include <pathmark/coursework.h>

namespace pathmark {

// Part 6.1 (handout section 6.1): end paths that carry little, without bias.
//
// Choose a probability q to survive, from the throughput and the depth. With probability q
// (u < q) the path survives with weight 1/q, else it ends: so the mean of survives * weight over u
// is 1. From depth 4 on, a throughput of at most 0.5 in every channel must really end paths now
// and then: 0.05 <= q <= 0.95. A throughput of 0 ends at once: {false, 0}.
//
//   throughput   what the path's light will be multiplied by, per channel
//   depth        scattering events so far, 1, 2, ...
//   u            uniform in [0,1)
//
// Returns whether the path survives, and its weight if it does.
Roulette LitScene::RussianRoulette(const Colour& /*throughput*/, int /*depth*/, float /*u*/) const {
  PATHMARK_UNIMPLEMENTED("part6_roulette.cpp", "LitScene::RussianRoulette");
  return {true, 1.0f};
}

}  // namespace pathmark
