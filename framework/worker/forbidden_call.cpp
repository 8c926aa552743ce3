#include "worker/forbidden_call.h"

#include <cerrno>
#include <cstring>
#include <string_view>

#include <sys/syscall.h>
#include <ucontext.h>

namespace pathmark {

namespace {

// SYS_SECCOMP of asm-generic/siginfo.h, which cannot be included beside the C library's.
constexpr int kByFilter = 1;

// Of Embree's task scheduler, of the allocator, of locales and of the clock.
constexpr std::string_view kHarmless[] = {
    "/sys/",           "/proc/sys/",        "/proc/meminfo",
    "/proc/cpuinfo",   "/proc/mounts",      "/proc/stat",
    "/proc/self/cgro", "/proc/self/mounti", "/proc/filesystems",
    "/etc/ld.so.ca",   "/etc/localtime",    "/usr/share/zoneinfo",
    "/usr/lib/locale",
};
constexpr std::string_view kHarmlessLibraries[] = {"libtbb", "libhwloc", "libiomp", "libirml"};

std::uintptr_t argument(const void* context, int index) {
  [[maybe_unused]] const mcontext_t& registers =
      static_cast<const ucontext_t*>(context)->uc_mcontext;
#if defined(__x86_64__)
  constexpr int kPlaces[] = {REG_RDI, REG_RSI, REG_RDX};
  return static_cast<std::uintptr_t>(registers.gregs[kPlaces[index]]);
#elif defined(__aarch64__)
  return registers.regs[index];
#else
  return 0;
#endif
}

void setResult(void* context, int error) {
  [[maybe_unused]] mcontext_t& registers = static_cast<ucontext_t*>(context)->uc_mcontext;
#if defined(__x86_64__)
  registers.gregs[REG_RAX] = -error;
#elif defined(__aarch64__)
  registers.regs[0] = static_cast<std::uint64_t>(-error);
#endif
}

// The path that the call names, if it names one.
const char* pathOf(int call, const void* context) {
  switch (call) {
#ifdef SYS_open
    case SYS_open:
    case SYS_creat:
    case SYS_stat:
    case SYS_access:
    case SYS_readlink:
    case SYS_unlink:
    case SYS_rename:
    case SYS_mkdir:
    case SYS_rmdir:
    case SYS_symlink:
#endif
    case SYS_execve:
    case SYS_chdir:
    case SYS_truncate:
      return reinterpret_cast<const char*>(argument(context, 0));
    case SYS_openat:
    case SYS_openat2:
    case SYS_execveat:
    case SYS_newfstatat:
    case SYS_faccessat:
    case SYS_faccessat2:
    case SYS_readlinkat:
    case SYS_statx:
    case SYS_unlinkat:
    case SYS_mkdirat:
    case SYS_renameat2:
      return reinterpret_cast<const char*>(argument(context, 1));
    default:
      return nullptr;
  }
}

bool isHarmless(std::string_view path) {
  if (path.find("..") != std::string_view::npos) return false;
  for (const std::string_view begin : kHarmless)
    if (path.starts_with(begin)) return true;
  const std::string_view name = path.substr(path.rfind('/') + 1);
  for (const std::string_view library : kHarmlessLibraries)
    if (name.starts_with(library)) return true;
  return false;
}

}  // namespace

bool isForbiddenCall(int signal, const siginfo_t& info) {
  return signal == SIGSYS && info.si_code == kByFilter;
}

bool answerHarmlessCall(const siginfo_t& info, void* context) {
  const char* path = pathOf(info.si_syscall, context);
  if (path == nullptr || !isHarmless(path)) return false;
  setResult(context, ENOENT);
  return true;
}

void describeCall(CrashRecord& record, const siginfo_t& info, const void* context) {
  record.systemCall = info.si_syscall;
  if (info.si_syscall == SYS_exit_group) {
    record.kind = CrashKind::kExit;
    return;
  }
  record.kind = CrashKind::kForbiddenCall;
  if (const char* path = pathOf(info.si_syscall, context))
    std::strncpy(record.text, path, sizeof record.text - 1);
}

}  // namespace pathmark
