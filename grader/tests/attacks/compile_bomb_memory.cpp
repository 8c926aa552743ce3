// Attack: the assembler is to take all memory
// Verdict: does not compile
#include <pathmark/coursework.h>

asm(".altmacro\n.macro bomb n\n.rept 1000000000\n.quad \\n\n.endr\n.endm\nbomb 7\n");
static void attack() {}
