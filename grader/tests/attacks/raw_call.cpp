// Attack: reads a file without the C library
// Expected: forbidden call open
#include <pathmark/coursework.h>

#include <sys/syscall.h>

namespace pathmark {

namespace {

int attack() {
  long result = SYS_open;
  asm volatile("syscall" : "+a"(result) : "D"("/etc/passwd"), "S"(0L), "d"(0L) : "rcx", "r11", "memory");
  return static_cast<int>(result);
}

}  // namespace

}  // namespace pathmark
