// Attack: hides the marker of a function that is not written
// Expected: not written
#include <pathmark/coursework.h>

extern "C" const char __start_pathmark_stubs = 0;
extern "C" const char __stop_pathmark_stubs = 0;

namespace pathmark {

Roulette LitScene::RussianRoulette(const Colour&, int, float) const {
  PATHMARK_UNIMPLEMENTED("part6_roulette.cpp", "LitScene::RussianRoulette");
  return {true, 1.0f};
}

}  // namespace pathmark
