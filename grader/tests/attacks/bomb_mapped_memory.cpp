// Attack: maps memory until there is none
// Verdict: memory limit, crashed
#include <pathmark/coursework.h>

#include <sys/mman.h>
#include <cstring>
static void attack() {
  for (;;)
    std::memset(mmap(nullptr, 64 << 20, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0),
                1, 64 << 20);
}
