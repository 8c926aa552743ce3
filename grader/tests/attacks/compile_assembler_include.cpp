// Attack: the assembler is to quote a secret in its messages
// Verdict: does not compile
#include <pathmark/coursework.h>

asm(".include \"@SECRET_FILE@\"");
static void attack() {}
