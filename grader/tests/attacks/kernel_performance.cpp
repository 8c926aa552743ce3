// Attack: measures other processes
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <sys/syscall.h>
#include <unistd.h>
static void attack() { syscall(SYS_perf_event_open, nullptr, 0, -1, -1, 0); }
