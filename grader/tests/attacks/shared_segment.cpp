// Attack: shares memory with other processes
// Expected: forbidden call shmget
#include <pathmark/coursework.h>

#include <sys/shm.h>
#include <sys/ipc.h>

namespace pathmark {

namespace {

int attack() {
  return shmget(IPC_PRIVATE, 1 << 20, IPC_CREAT | 0600);
}

}  // namespace

}  // namespace pathmark
