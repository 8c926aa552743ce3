// Attack: closes the wire
// Verdict: crashed
#include <pathmark/coursework.h>

#include <unistd.h>
static void attack() { close(3); }
