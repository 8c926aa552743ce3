// Attack: lists a folder
// Expected: forbidden call openat
#include <pathmark/coursework.h>

#include <filesystem>

namespace pathmark {

namespace {

int attack() {
  return std::filesystem::directory_iterator("@CANARY@") != std::filesystem::directory_iterator{};
}

}  // namespace

}  // namespace pathmark
