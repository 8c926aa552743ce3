// Attack: becomes a program that no file holds
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <sys/mman.h>
#include <unistd.h>
static void attack() {
  const int fd = memfd_create("program", 0);
  char* const arguments[] = {const_cast<char*>("program"), nullptr};
  fexecve(fd, arguments, environ);
}
