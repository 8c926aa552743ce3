#include "worker/lock.h"

#include "intersect/embree_intersector.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace pathmark {

namespace {

#if defined(__x86_64__)
constexpr std::uint32_t kProcessor = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kProcessor = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kProcessor = 0;
#endif

// A filter that allows everything but what is added. The accumulator holds the call's number
// between the rules.
class Filter {
 public:
  Filter() {
    load(offsetof(seccomp_data, arch));
    add(BPF_JMP | BPF_JEQ | BPF_K, kProcessor, 1, 0);
    add(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS);
    load(offsetof(seccomp_data, nr));
  }

  void refuse(long call) {
    add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 1);
    add(BPF_RET | BPF_K, SECCOMP_RET_TRAP);
  }

  // With this value of an argument, or with any other.
  void refuseIf(long call, std::size_t argument, std::uint32_t value) {
    refuse(call, argument, value, true);
  }
  void refuseUnless(long call, std::size_t argument, std::uint32_t value) {
    refuse(call, argument, value, false);
  }

  bool install() {
    add(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    const sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
    return kProcessor != 0 && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program) == 0;
  }

 private:
  void add(int code, std::uint32_t k, std::uint8_t ifTrue = 0, std::uint8_t ifFalse = 0) {
    code_.push_back({static_cast<std::uint16_t>(code), ifTrue, ifFalse, k});
  }
  void load(std::size_t offset) {
    add(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
  }
  void refuse(long call, std::size_t argument, std::uint32_t value, bool whenEqual) {
    add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 4);
    // The lower half: both processors are little-endian.
    load(offsetof(seccomp_data, args) + 8 * argument);
    add(BPF_JMP | BPF_JEQ | BPF_K, value, whenEqual ? 0 : 1, whenEqual ? 1 : 0);
    add(BPF_RET | BPF_K, SECCOMP_RET_TRAP);
    load(offsetof(seccomp_data, nr));
  }

  std::vector<sock_filter> code_;
};

}  // namespace

bool lockWorker() {
  warmUpEmbree();
  Filter filter;
#ifdef SYS_open
  for (const long call : {SYS_open, SYS_creat, SYS_access, SYS_stat, SYS_lstat, SYS_readlink})
    filter.refuse(call);
#endif
  for (const long call : {SYS_openat, SYS_openat2, SYS_execve, SYS_execveat, SYS_faccessat,
                          SYS_faccessat2, SYS_readlinkat, SYS_statx, SYS_prctl, SYS_seccomp})
    filter.refuse(call);
  // The handler that reports all this stays, and signals stay within the process.
  filter.refuseIf(SYS_rt_sigaction, 0, SIGSYS);
  filter.refuseUnless(SYS_tgkill, 0, static_cast<std::uint32_t>(getpid()));
  // A worker that kills itself would look as if memory had run out.
  filter.refuseIf(SYS_tgkill, 2, SIGKILL);
  // The end of main() is the only one.
  filter.refuseUnless(SYS_exit_group, 0, 0);
  return filter.install();
}

}  // namespace pathmark
