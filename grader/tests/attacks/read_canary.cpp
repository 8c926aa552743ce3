// Attack: reads a file of the machine
// Expected: forbidden call openat
// Says: part6_roulette.cpp:
#include <pathmark/coursework.h>

#include <cstdio>

namespace pathmark {

namespace {

int attack() {
  return std::fopen("@CANARY@/canary", "r") != nullptr;
}

}  // namespace

}  // namespace pathmark
