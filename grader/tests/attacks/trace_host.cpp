// Attack: traces the host
// Expected: forbidden call ptrace
#include <pathmark/coursework.h>

#include <sys/ptrace.h>

namespace pathmark {

namespace {

int attack() {
  return static_cast<int>(ptrace(PTRACE_ATTACH, @HOST@, nullptr, nullptr));
}

}  // namespace

}  // namespace pathmark
