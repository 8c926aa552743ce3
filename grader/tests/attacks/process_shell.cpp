// Attack: runs a command
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <cstdlib>
static void attack() { std::system("touch @OUTSIDE@/new"); }
