// Attack: the assembler is to put the solutions into the program
// Verdict: does not compile
#include <pathmark/coursework.h>

asm(".section .rodata\n.global stolen\nstolen: .incbin \"@SOLUTIONS@/part6_roulette.cpp\"\n.text");
static void attack() {}
