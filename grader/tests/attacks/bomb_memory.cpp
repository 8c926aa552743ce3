// Attack: takes all memory
// Verdict: memory limit
#include <pathmark/coursework.h>

#include <cstring>
static void attack() {
  for (;;) std::memset(new char[64 << 20], 1, 64 << 20);
}
