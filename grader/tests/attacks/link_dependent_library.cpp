// Attack: the linker is asked for the solutions by a section that names libraries
// Verdict: ok
#include <pathmark/coursework.h>

asm(".section .deplibs,\"MS\",@0x6fff4c04,1\n.asciz \"@SOLUTIONS@/part6_roulette.o\"\n.text");
static void attack() {}
