// Attack: the assembler is to put a secret into the program
// Verdict: does not compile
#include <pathmark/coursework.h>

asm(".section .rodata\n.global stolen\nstolen: .incbin \"@SECRET_FILE@\"\n.text");
static void attack() {}
