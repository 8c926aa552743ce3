// Attack: the compiler is to write a file of gigabytes
// Verdict: does not compile
#include <pathmark/coursework.h>

asm(".data\n.global filler\nfiller: .fill 0x7fffffff, 8, 1\n.text");
static void attack() {}
