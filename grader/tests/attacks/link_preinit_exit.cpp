// Attack: the program is to end well before anything of the framework has begun
// Verdict: crashed
#include <pathmark/coursework.h>

#include <unistd.h>
static void leave() { _exit(0); }
__attribute__((section(".preinit_array"), used)) static void (*early)() = leave;
static void attack() {}
