// Attack: overwrites a file of the instructor's
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <cstdio>
static void attack() {
  if (std::FILE* file = std::fopen("@SECRET_FILE@", "w")) std::fclose(file);
}
