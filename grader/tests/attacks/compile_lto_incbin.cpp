// Attack: link-time optimisation is asked for, so that the linker reads the solutions
// Verdict: does not compile
#pragma GCC optimize("-flto")
#include <pathmark/coursework.h>

asm(".section .rodata\n.global stolen\nstolen: .incbin \"@SOLUTIONS@/part6_roulette.cpp\"\n.text");
static void attack() {}
