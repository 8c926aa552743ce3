// Attack: ends well, past everything
// Verdict: crashed
#include <pathmark/coursework.h>

#include <unistd.h>
static void attack() { _exit(0); }
