// Attack: the compiler is to quote a secret in its messages
// Verdict: does not compile
#include "@SECRET_FILE@"
