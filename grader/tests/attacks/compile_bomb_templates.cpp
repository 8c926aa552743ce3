// Attack: the compiler is to instantiate templates without end
// Verdict: does not compile
#include <pathmark/coursework.h>

template <int N, int M>
struct Bomb {
  static constexpr long value = Bomb<N - 1, 2 * M>::value + Bomb<N - 1, 2 * M + 1>::value;
};
template <int M>
struct Bomb<0, M> {
  static constexpr long value = M;
};
static void attack() { volatile long size = Bomb<30, 1>::value; }
