// Attack: the compiler is to quote the environment of the process before it
// Verdict: does not compile
#include "/proc/1/environ"
