// Attack: the compiler is to say which files there are
// Verdict: ok
#include <pathmark/coursework.h>

#if __has_include("@SECRET_FILE@") || __has_include("@SOLUTIONS@/part6_roulette.cpp")
#error The file is there.
#endif
static void attack() {}
