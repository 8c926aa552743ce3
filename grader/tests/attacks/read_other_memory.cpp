// Attack: reads the memory of the process that started it
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <sys/uio.h>
#include <unistd.h>
#include <cstdio>
static void attack() {
  char bytes[64];
  iovec here{bytes, sizeof bytes}, there{reinterpret_cast<void*>(0x400000), sizeof bytes};
  if (process_vm_readv(getppid(), &here, 1, &there, 1, 0) > 0) std::puts("@SECRET@");
}
