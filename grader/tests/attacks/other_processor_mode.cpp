// Attack: calls the system as a 32-bit program
// Expected: forbidden call
#include <pathmark/coursework.h>

namespace pathmark {

namespace {

int attack() {
  int result = 20;
  asm volatile("int $0x80" : "+a"(result) : : "memory");
  return result;
}

}  // namespace

}  // namespace pathmark
