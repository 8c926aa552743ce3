// Attack: loads a program into the kernel
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <sys/syscall.h>
#include <unistd.h>
static void attack() { syscall(SYS_bpf, 0, nullptr, 0); }
