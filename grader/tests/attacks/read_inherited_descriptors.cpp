// Attack: looks for files that somebody has left open
// Verdict: ok
#include <pathmark/coursework.h>

#include <fcntl.h>
#include <cstdio>
static void attack() {
  for (int fd = 5; fd < 4096; ++fd)
    if (fcntl(fd, F_GETFD) != -1) std::puts("@SECRET@");
}
