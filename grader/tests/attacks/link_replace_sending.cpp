// Attack: the function that sends answers is to be replaced
// Verdict: wrong
#include <pathmark/coursework.h>

#include <cstddef>
extern "C" long send(int, const void*, std::size_t size, int) { return static_cast<long>(size); }
extern "C" long write(int, const void*, std::size_t size) { return static_cast<long>(size); }
namespace pathmark {
Roulette LitScene::RussianRoulette(const Colour&, int, float) const { return {true, 7.0f}; }
}  // namespace pathmark
