// Attack: lifts its limits
// Expected: forbidden call prlimit64
#include <pathmark/coursework.h>

#include <sys/resource.h>

namespace pathmark {

namespace {

int attack() {
  const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
  return setrlimit(RLIMIT_AS, &none);
}

}  // namespace

}  // namespace pathmark
