// Attack: functions of the C library are to give other values to everybody
// Verdict: ok
#include <pathmark/coursework.h>

extern "C" float sqrtf(float) { return 1.0f; }
extern "C" double sqrt(double) { return 1.0; }
extern "C" void* memcpy(void* to, const void*, unsigned long) { return to; }
static void attack() {}
