// Attack: reads the kernel's keys
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <sys/syscall.h>
#include <unistd.h>
static void attack() { syscall(SYS_keyctl, 0, -3, 0); }
