// Lab: no roulette. Handout: handouts/labs.md, section 4
#include <pathmark/coursework.h>

namespace pathmark {

// Every path goes on, with factor 1, until maxBounces(), unless its throughput is zero: then it
// ends.
//
//   throughput   of the path so far
//
// Returns whether the path goes on, and the factor on its throughput.
Roulette LitScene::RussianRoulette(const Colour& /*throughput*/, int /*depth*/, float /*u*/) const {
  PATHMARK_UNIMPLEMENTED("part6_roulette.cpp", "LitScene::RussianRoulette");
  return {true, 1.0f};
}

}  // namespace pathmark
