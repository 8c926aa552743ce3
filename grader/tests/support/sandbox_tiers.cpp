#include "support/sandbox_tiers.h"

#include "sandbox/bubblewrap_tier.h"
#include "sandbox/landlock.h"

#include <map>
#include <mutex>

#include <sched.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pathmark::test {

namespace {

// Asked of the kernel itself, as the user that a sandboxed program has.
bool kernelGivesNamespaces() {
  const pid_t child = fork();
  if (child == 0) {
    if (geteuid() == 0) {
      const uid_t user = 65534;
      if (syscall(SYS_setresgid, user, user, user) != 0 ||
          syscall(SYS_setresuid, user, user, user) != 0)
        _exit(1);
    }
    _exit(unshare(CLONE_NEWUSER | CLONE_NEWNS | CLONE_NEWPID | CLONE_NEWNET) == 0 ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

std::vector<sandbox::Tier> expectedTiers() {
  std::vector<sandbox::Tier> tiers;
  if (!sandbox::findBubblewrap().empty() && kernelGivesNamespaces())
    tiers.push_back(sandbox::Tier::kBubblewrap);
  if (sandbox::landlockVersion() > 0 || tiers.empty()) tiers.push_back(sandbox::Tier::kLandlock);
  return tiers;
}

std::shared_ptr<Confinement> sandboxOf(sandbox::Tier tier) {
  static std::mutex mutex;
  static std::map<sandbox::Tier, std::shared_ptr<Confinement>> opened;
  const std::lock_guard lock(mutex);
  std::shared_ptr<Confinement>& here = opened[tier];
  if (!here) here = sandbox::openSandbox(tier);
  return here;
}

}  // namespace pathmark::test
