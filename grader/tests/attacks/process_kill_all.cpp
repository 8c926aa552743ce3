// Attack: ends every process that it may
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <csignal>
static void attack() { kill(-1, SIGKILL); }
