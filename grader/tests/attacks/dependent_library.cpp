// Attack: asks the linker for a file of the host's, in a section that names libraries
// Expected: ok or does not compile or does not link
#include <pathmark/coursework.h>

asm(".section .deplibs, \"MS\", @0x6fff4c04, 1\n"
    ".asciz \"@ROOT@/solutions/part6_roulette.cpp\"\n"
    ".text");

namespace pathmark {

namespace {

int attack() { return 0; }

}  // namespace

}  // namespace pathmark
