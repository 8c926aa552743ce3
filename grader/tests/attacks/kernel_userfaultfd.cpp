// Attack: handles its own page faults
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <sys/syscall.h>
#include <unistd.h>
static void attack() { syscall(SYS_userfaultfd, 0); }
