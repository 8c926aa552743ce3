// Attack: loads a program into the kernel
// Expected: forbidden call bpf
#include <pathmark/coursework.h>

#include <unistd.h>
#include <sys/syscall.h>

namespace pathmark {

namespace {

int attack() {
  return static_cast<int>(syscall(SYS_bpf, 0, nullptr, 0));
}

}  // namespace

}  // namespace pathmark
