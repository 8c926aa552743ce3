// Attack: the compiler is to read without end
// Verdict: does not compile
#include "/dev/zero"
