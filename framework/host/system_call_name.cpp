#include "host/system_call_name.h"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>

#include <sys/syscall.h>

// Not all processors have all of them.
#ifdef __x86_64__
#define PATHMARK_X86_CALL(name) std::pair<int, std::string_view>{SYS_##name, #name},
#else
#define PATHMARK_X86_CALL(name)
#endif
#define PATHMARK_CALL(name) std::pair<int, std::string_view>{SYS_##name, #name},

namespace pathmark {

namespace {

// clang-format off
constexpr auto kNames = std::to_array<std::pair<int, std::string_view>>({
  PATHMARK_CALL(accept) PATHMARK_CALL(accept4) PATHMARK_X86_CALL(access) PATHMARK_CALL(acct)
  PATHMARK_CALL(add_key) PATHMARK_CALL(adjtimex) PATHMARK_X86_CALL(alarm) PATHMARK_CALL(bind)
  PATHMARK_CALL(bpf) PATHMARK_CALL(capset) PATHMARK_CALL(chdir) PATHMARK_X86_CALL(chmod)
  PATHMARK_X86_CALL(chown) PATHMARK_CALL(chroot) PATHMARK_CALL(clock_settime) PATHMARK_CALL(clone)
  PATHMARK_CALL(clone3) PATHMARK_CALL(connect) PATHMARK_CALL(copy_file_range)
  PATHMARK_X86_CALL(creat) PATHMARK_CALL(dup) PATHMARK_X86_CALL(dup2) PATHMARK_CALL(dup3)
  PATHMARK_CALL(epoll_create1) PATHMARK_CALL(eventfd2) PATHMARK_CALL(execve)
  PATHMARK_CALL(execveat) PATHMARK_CALL(exit_group) PATHMARK_CALL(faccessat)
  PATHMARK_CALL(faccessat2) PATHMARK_CALL(fallocate) PATHMARK_CALL(fanotify_init)
  PATHMARK_CALL(fchdir) PATHMARK_CALL(fchmod) PATHMARK_CALL(fchmodat) PATHMARK_CALL(fchown)
  PATHMARK_CALL(fchownat) PATHMARK_CALL(fcntl) PATHMARK_CALL(finit_module) PATHMARK_X86_CALL(fork)
  PATHMARK_CALL(fstatfs) PATHMARK_CALL(ftruncate) PATHMARK_CALL(getdents64)
  PATHMARK_CALL(getrandom) PATHMARK_CALL(init_module) PATHMARK_CALL(inotify_init1)
  PATHMARK_CALL(io_uring_enter) PATHMARK_CALL(io_uring_register) PATHMARK_CALL(io_uring_setup)
  PATHMARK_CALL(ioctl) PATHMARK_X86_CALL(ioperm) PATHMARK_X86_CALL(iopl) PATHMARK_CALL(kcmp)
  PATHMARK_CALL(kexec_load) PATHMARK_CALL(keyctl) PATHMARK_CALL(kill)
  PATHMARK_CALL(landlock_add_rule) PATHMARK_CALL(landlock_create_ruleset)
  PATHMARK_CALL(landlock_restrict_self) PATHMARK_X86_CALL(link) PATHMARK_CALL(linkat)
  PATHMARK_CALL(listen) PATHMARK_X86_CALL(lstat) PATHMARK_CALL(memfd_create)
  PATHMARK_CALL(memfd_secret) PATHMARK_X86_CALL(mkdir) PATHMARK_CALL(mkdirat)
  PATHMARK_X86_CALL(mknod) PATHMARK_CALL(mknodat) PATHMARK_CALL(mlock) PATHMARK_CALL(mlockall)
  PATHMARK_X86_CALL(modify_ldt) PATHMARK_CALL(mount) PATHMARK_CALL(mq_open) PATHMARK_CALL(msgget)
  PATHMARK_CALL(name_to_handle_at) PATHMARK_CALL(newfstatat) PATHMARK_X86_CALL(open)
  PATHMARK_CALL(open_by_handle_at) PATHMARK_CALL(openat) PATHMARK_CALL(openat2)
  PATHMARK_CALL(perf_event_open) PATHMARK_CALL(personality) PATHMARK_CALL(pidfd_getfd)
  PATHMARK_CALL(pidfd_open) PATHMARK_CALL(pidfd_send_signal) PATHMARK_X86_CALL(pipe)
  PATHMARK_CALL(pipe2) PATHMARK_CALL(pivot_root) PATHMARK_CALL(prctl) PATHMARK_CALL(prlimit64)
  PATHMARK_CALL(process_madvise) PATHMARK_CALL(process_vm_readv) PATHMARK_CALL(process_vm_writev)
  PATHMARK_CALL(ptrace) PATHMARK_CALL(quotactl) PATHMARK_CALL(read) PATHMARK_X86_CALL(readlink)
  PATHMARK_CALL(readlinkat) PATHMARK_CALL(reboot) PATHMARK_CALL(recvfrom)
  PATHMARK_X86_CALL(rename) PATHMARK_CALL(renameat) PATHMARK_CALL(renameat2)
  PATHMARK_CALL(request_key) PATHMARK_X86_CALL(rmdir) PATHMARK_CALL(rt_sigaction)
  PATHMARK_CALL(rt_sigprocmask) PATHMARK_CALL(rt_sigqueueinfo) PATHMARK_CALL(rt_tgsigqueueinfo)
  PATHMARK_CALL(sched_setaffinity) PATHMARK_CALL(sched_setattr) PATHMARK_CALL(sched_setscheduler)
  PATHMARK_CALL(seccomp) PATHMARK_CALL(semget) PATHMARK_CALL(sendfile) PATHMARK_CALL(sendmsg)
  PATHMARK_CALL(sendto) PATHMARK_CALL(setgid) PATHMARK_CALL(setgroups) PATHMARK_CALL(sethostname)
  PATHMARK_CALL(setitimer) PATHMARK_CALL(setns) PATHMARK_CALL(setpgid) PATHMARK_CALL(setpriority)
  PATHMARK_CALL(setresgid) PATHMARK_CALL(setresuid) PATHMARK_CALL(setrlimit) PATHMARK_CALL(setsid)
  PATHMARK_CALL(settimeofday) PATHMARK_CALL(setuid) PATHMARK_CALL(shmat) PATHMARK_CALL(shmctl)
  PATHMARK_CALL(shmget) PATHMARK_CALL(signalfd4) PATHMARK_CALL(socket) PATHMARK_CALL(socketpair)
  PATHMARK_CALL(splice) PATHMARK_X86_CALL(stat) PATHMARK_CALL(statfs) PATHMARK_CALL(statx)
  PATHMARK_CALL(swapon) PATHMARK_X86_CALL(symlink) PATHMARK_CALL(symlinkat) PATHMARK_CALL(syslog)
  PATHMARK_CALL(tee) PATHMARK_CALL(tgkill) PATHMARK_CALL(timer_create)
  PATHMARK_CALL(timerfd_create) PATHMARK_CALL(tkill) PATHMARK_CALL(truncate)
  PATHMARK_CALL(umount2) PATHMARK_X86_CALL(unlink) PATHMARK_CALL(unlinkat) PATHMARK_CALL(unshare)
  PATHMARK_CALL(userfaultfd) PATHMARK_CALL(utimensat) PATHMARK_X86_CALL(vfork)
  PATHMARK_CALL(vmsplice) PATHMARK_CALL(wait4) PATHMARK_CALL(waitid) PATHMARK_CALL(write)
});
// clang-format on

}  // namespace

std::string systemCallName(int number) {
  for (const auto& [known, name] : kNames)
    if (known == number) return std::string(name);
  return fmt::format("number {}", number);
}

}  // namespace pathmark
