// Attack: removes a file of the machine
// Expected: forbidden call
#include <pathmark/coursework.h>

#include <filesystem>

namespace pathmark {

namespace {

int attack() {
  return std::filesystem::remove("@CANARY@/canary");
}

}  // namespace

}  // namespace pathmark
