// Attack: writes a crash record of its own
// Expected: crashed or forbidden call
#include <pathmark/coursework.h>

#include <unistd.h>
#include <cstdlib>

namespace pathmark {

namespace {

int attack() {
  const unsigned record[512] = {0x48535243, 6, 0, 0xffffffff};
  [[maybe_unused]] const long n = write(4, record, sizeof record);
  std::abort();
}

}  // namespace

}  // namespace pathmark
