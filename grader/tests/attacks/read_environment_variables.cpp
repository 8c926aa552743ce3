// Attack: prints the environment that it was started with
// Verdict: ok
#include <pathmark/coursework.h>

#include <unistd.h>
#include <cstdio>
static void attack() {
  for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable)
    std::puts(*variable);
}
