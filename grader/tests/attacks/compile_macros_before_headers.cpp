// Attack: macros are to change what the headers declare
// Verdict: does not compile
#define private public
#define const
#include <pathmark/coursework.h>

static void attack() {}
