// Attack: the compiler is to quote the machine's users
// Verdict: does not compile
#include "/etc/passwd"
