// Attack: ends the process that started it
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <unistd.h>
#include <csignal>
static void attack() { kill(getppid(), SIGKILL); }
