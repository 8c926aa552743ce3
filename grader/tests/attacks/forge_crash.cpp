// Attack: says of itself that somebody else has crashed
// Verdict: crashed
#include <pathmark/coursework.h>

#include <unistd.h>
#include <cstdint>
#include <cstring>
static void attack() {
  static char record[1024];
  const std::uint32_t head[] = {0x48535243u, 3, 6, 1};
  std::memcpy(record, head, sizeof head);
  std::strcpy(record + sizeof head, "the grader has failed: full marks");
  if (write(4, record, sizeof record) > 0) _exit(0);
}
