// Attack: fills the disk
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <fcntl.h>
#include <unistd.h>
static void attack() {
  static char block[1 << 20];
  const int fd = open("/tmp/pathmark_filler", O_WRONLY | O_CREAT, 0666);
  while (fd >= 0 && write(fd, block, sizeof block) > 0) {
  }
}
