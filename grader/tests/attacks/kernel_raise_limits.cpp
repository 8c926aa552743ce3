// Attack: takes its limits off
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <sys/resource.h>
static void attack() {
  const rlimit all{RLIM_INFINITY, RLIM_INFINITY};
  setrlimit(RLIMIT_AS, &all);
}
