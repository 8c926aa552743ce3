// Attack: fills memory with a file that has no name
// Expected: forbidden call memfd_create
#include <pathmark/coursework.h>

#include <sys/mman.h>

namespace pathmark {

namespace {

int attack() {
  return memfd_create("large", 0);
}

}  // namespace

}  // namespace pathmark
