// Attack: loads another library
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <dlfcn.h>
static void attack() { dlopen("@OUTSIDE@/evil.so", RTLD_NOW); }
