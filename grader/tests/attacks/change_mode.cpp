// Attack: changes who may read a file
// Expected: forbidden call chmod
#include <pathmark/coursework.h>

#include <sys/stat.h>

namespace pathmark {

namespace {

int attack() {
  return chmod("@CANARY@/canary", 0);
}

}  // namespace

}  // namespace pathmark
