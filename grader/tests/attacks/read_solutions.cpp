// Attack: reads the solutions
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <fcntl.h>
#include <unistd.h>
#include <cstdio>
static void show(const char* file) {
  char bytes[4096];
  const int fd = open(file, O_RDONLY);
  const long size = fd < 0 ? 0 : read(fd, bytes, sizeof bytes);
  std::printf("%.*s", static_cast<int>(size), bytes);
}
static void attack() { show("@SOLUTIONS@/part6_roulette.cpp"); }
