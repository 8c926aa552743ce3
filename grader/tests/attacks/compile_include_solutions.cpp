// Attack: the compiler is to read the solutions
// Verdict: does not compile
#include "@SOLUTIONS@/part6_roulette.cpp"
