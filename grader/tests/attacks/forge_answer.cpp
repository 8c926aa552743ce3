// Attack: writes an answer of its own onto the wire
// Verdict: wrong
#include <pathmark/coursework.h>

#include <sys/socket.h>
#include <cstdint>
static void attack() {
  // As the framework writes them: magic, kind, sequence, nothing, length.
  const std::uint32_t answer[] = {0x31574d50u, 6, 2, 0, 8, 0, 1, 0x3f800000u};
  send(3, answer, sizeof answer, 0);
}
