// Attack: makes a folder
// Expected: forbidden call mkdir
#include <pathmark/coursework.h>

#include <sys/stat.h>

namespace pathmark {

namespace {

int attack() {
  return mkdir("@CANARY@/made", 0777);
}

}  // namespace

}  // namespace pathmark
