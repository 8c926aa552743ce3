#include "sandbox/call_filter.h"

#include "host/build_config.h"
#include "host/shared_memory.h"

#include <cerrno>
#include <memory>
#include <system_error>

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace pathmark::sandbox {

namespace {

// What every program needs to start, to compute on several threads and to end. Names that this
// processor does not have are passed over.
constexpr const char* kComputing[] = {"read",
                                      "readv",
                                      "pread64",
                                      "write",
                                      "writev",
                                      "close",
                                      "fstat",
                                      "newfstatat",
                                      "lseek",
                                      "mmap",
                                      "munmap",
                                      "mprotect",
                                      "mremap",
                                      "madvise",
                                      "brk",
                                      "futex",
                                      "set_robust_list",
                                      "get_robust_list",
                                      "rseq",
                                      "set_tid_address",
                                      "arch_prctl",
                                      "rt_sigaction",
                                      "rt_sigprocmask",
                                      "rt_sigreturn",
                                      "sigaltstack",
                                      "sched_yield",
                                      "sched_getaffinity",
                                      "sched_getparam",
                                      "sched_getscheduler",
                                      "gettid",
                                      "getpid",
                                      "getppid",
                                      "getuid",
                                      "geteuid",
                                      "getgid",
                                      "getegid",
                                      "getpgrp",
                                      "exit",
                                      "exit_group",
                                      "execve",
                                      "execveat",
                                      "access",
                                      "faccessat",
                                      "faccessat2",
                                      "open",
                                      "openat",
                                      "readlink",
                                      "readlinkat",
                                      "getrandom",
                                      "clock_gettime",
                                      "clock_getres",
                                      "gettimeofday",
                                      "time",
                                      "nanosleep",
                                      "clock_nanosleep",
                                      "poll",
                                      "ppoll",
                                      "pause",
                                      "select",
                                      "pselect6",
                                      "getrusage",
                                      "times",
                                      "sysinfo",
                                      "uname",
                                      "getrlimit",
                                      "restart_syscall",
                                      "membarrier",
                                      "getcpu",
                                      "stat",
                                      "lstat",
                                      "statx"};

constexpr const char* kTools[] = {"clone",
                                  "fork",
                                  "vfork",
                                  "wait4",
                                  "waitid",
                                  "pipe",
                                  "pipe2",
                                  "dup",
                                  "dup2",
                                  "dup3",
                                  "kill",
                                  "tgkill",
                                  "fcntl",
                                  "unlink",
                                  "unlinkat",
                                  "rename",
                                  "renameat",
                                  "renameat2",
                                  "chmod",
                                  "fchmod",
                                  "fchmodat",
                                  "umask",
                                  "ftruncate",
                                  "fallocate",
                                  "fadvise64",
                                  "getcwd",
                                  "getdents64",
                                  "statfs",
                                  "fstatfs",
                                  "pwrite64",
                                  "pwritev",
                                  "preadv",
                                  "copy_file_range",
                                  "sendfile",
                                  "flock",
                                  "fsync",
                                  "fdatasync",
                                  "msync",
                                  "mincore",
                                  "utimensat",
                                  "mkdir",
                                  "mkdirat",
                                  "rmdir",
                                  "sched_setaffinity"};

class Context {
 public:
  explicit Context(std::uint32_t otherwise) : context_(seccomp_init(otherwise)) {
    if (!context_) throw std::system_error(ENOMEM, std::generic_category(), "a seccomp filter");
    check(seccomp_attr_set(context_, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS));
    check(seccomp_attr_set(context_, SCMP_FLTATR_CTL_OPTIMIZE, 2));
  }
  ~Context() { seccomp_release(context_); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  template <class... Conditions>
  void rule(std::uint32_t action, const char* call, Conditions... conditions) {
    const int number = seccomp_syscall_resolve_name(call);
    if (number == __NR_SCMP_ERROR) return;
    const int error =
        seccomp_rule_add(context_, action, number, sizeof...(conditions), conditions...);
    // A pseudo number: this processor does not have the call.
    if (error != -EDOM && error != -EACCES) check(error);
  }

  template <class... Conditions>
  void allow(const char* call, Conditions... conditions) {
    rule(SCMP_ACT_ALLOW, call, conditions...);
  }

  CallFilter build() const {
    const FileDescriptor file(memfd_create("filter", MFD_CLOEXEC));
    check(seccomp_export_bpf(context_, file.get()));
    CallFilter filter(static_cast<std::size_t>(lseek(file.get(), 0, SEEK_END)) /
                      sizeof(sock_filter));
    const std::size_t bytes = filter.size() * sizeof(sock_filter);
    if (pread(file.get(), filter.data(), bytes, 0) != static_cast<ssize_t>(bytes))
      throw std::system_error(errno, std::generic_category(), "a seccomp filter");
    return filter;
  }

 private:
  static void check(int error) {
    if (error < 0) throw std::system_error(-error, std::generic_category(), "a seccomp filter");
  }

  scmp_filter_ctx context_;
};

void allowComputing(Context& context) {
  for (const char* call : kComputing) context.allow(call);
  // The C library then takes clone, whose flags a filter can see.
  context.rule(SCMP_ACT_ERRNO(ENOSYS), "clone3");
  context.allow("prlimit64", SCMP_A2(SCMP_CMP_EQ, 0));  // asking, not setting
  context.allow("ioctl", SCMP_A1(SCMP_CMP_EQ, TCGETS));
}

void allowSanitizers(Context& context) {
  for (const char* call :
       {"prctl", "personality", "sched_setaffinity", "getdents64", "dup", "pipe2"})
    context.allow(call);
  context.allow("prlimit64", SCMP_A1(SCMP_CMP_EQ, RLIMIT_CORE));
}

}  // namespace

CallFilter workerFilter(bool ownSignalsOnly) {
  Context context(SCMP_ACT_TRAP);
  allowComputing(context);
  context.allow("clone", SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD));
  context.allow("recvmsg");
  context.allow("sendto");
  for (const int command : {F_GETFD, F_SETFD, F_GETFL})
    context.allow("fcntl", SCMP_A1(SCMP_CMP_EQ, static_cast<scmp_datum_t>(command)));
  if (ownSignalsOnly)
    context.allow("tgkill", SCMP_A0(SCMP_CMP_EQ, kOwnProcess));
  else
    context.allow("tgkill");
  // The worker's own lock.
  context.allow("prctl", SCMP_A0(SCMP_CMP_EQ, PR_SET_NO_NEW_PRIVS));
  context.allow("seccomp");
  if (build::kSanitized) allowSanitizers(context);
  return context.build();
}

CallFilter toolFilter() {
  Context context(SCMP_ACT_ERRNO(EPERM));
  allowComputing(context);
  for (const char* call : kTools) context.allow(call);
  return context.build();
}

}  // namespace pathmark::sandbox
