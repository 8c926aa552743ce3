// Attack: writes a file outside
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <fcntl.h>
#include <unistd.h>
static void attack() {
  const int fd = open("@OUTSIDE@/new", O_WRONLY | O_CREAT, 0666);
  if (fd >= 0 && write(fd, "x", 1) == 1) close(fd);
}
