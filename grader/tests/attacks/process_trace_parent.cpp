// Attack: takes over the process that started it
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <sys/ptrace.h>
#include <unistd.h>
static void attack() { ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr); }
