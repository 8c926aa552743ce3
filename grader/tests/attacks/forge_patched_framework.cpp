// Attack: writes over the framework's own code
// Verdict: crashed, wrong, forbidden call
#include <pathmark/coursework.h>

#include <sys/mman.h>
#include <cstdint>
#include <cstring>
extern "C" const char __executable_start;
static void attack() {
  const auto start = reinterpret_cast<std::uintptr_t>(&__executable_start);
  mprotect(reinterpret_cast<void*>(start), 1 << 20, PROT_READ | PROT_WRITE | PROT_EXEC);
  std::memset(reinterpret_cast<void*>(start), 0x90, 1 << 20);
}
