// Attack: makes a machine of its own
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <sched.h>
static void attack() { unshare(CLONE_NEWUSER | CLONE_NEWNS); }
