// Attack: the compiler is to quote its environment
// Verdict: does not compile
#include "/proc/self/environ"
