// Attack: asks the kernel for input and output behind the filter
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <sys/syscall.h>
#include <unistd.h>
static void attack() { syscall(SYS_io_uring_setup, 8, nullptr); }
