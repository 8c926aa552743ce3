// Attack: takes memory from the system without end
// Expected: crashed
#include <pathmark/coursework.h>

#include <sys/mman.h>

namespace pathmark {

namespace {

int attack() {
  for (;;) {
    void* more = mmap(nullptr, 1 << 24, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    *static_cast<volatile char*>(more) = 1;
  }
}

}  // namespace

}  // namespace pathmark
