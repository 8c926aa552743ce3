// Attack: the file includes itself
// Verdict: does not compile
#include <pathmark/coursework.h>

#include __FILE__
static void attack() {}
