// Attack: reads the host's memory
// Expected: forbidden call process_vm_readv
#include <pathmark/coursework.h>

#include <sys/uio.h>

namespace pathmark {

namespace {

int attack() {
  char byte = 0;
  iovec here{&byte, 1}, there{reinterpret_cast<void*>(0x400000), 1};
  return static_cast<int>(process_vm_readv(@HOST@, &here, 1, &there, 1, 0));
}

}  // namespace

}  // namespace pathmark
