// A program that tries to get out of the sandbox, and tells what it could do.
//
// As a worker: reads a CanaryTask from the wire and writes one byte for each letter of kAttempts to
// it, 'y' or 'n'. As a tool (arguments: folder outside, scratch folder, process): prints the same.
#include "sandbox/canary.h"

#include "worker/protocol.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <ucontext.h>
#include <unistd.h>

namespace pathmark::sandbox {

namespace {

// A call that the filter traps fails like any other.
void refuse(int, siginfo_t*, void* context) {
  [[maybe_unused]] mcontext_t& registers = static_cast<ucontext_t*>(context)->uc_mcontext;
#if defined(__x86_64__)
  registers.gregs[REG_RAX] = -EPERM;
#elif defined(__aarch64__)
  registers.regs[0] = static_cast<unsigned long long>(-EPERM);
#endif
}

bool canOpen(const std::string& path, int flags) {
  const int fd = open(path.c_str(), flags, 0600);
  if (fd >= 0) close(fd);
  return fd >= 0;
}

bool canFork() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  if (child > 0) waitpid(child, nullptr, 0);
  return child > 0;
}

bool canStartThread() {
  pthread_t thread;
  const auto nothing = [](void*) -> void* { return nullptr; };
  return pthread_create(&thread, nullptr, nothing, nullptr) == 0 &&
         pthread_join(thread, nullptr) == 0;
}

bool canReachProcess(pid_t process) {
  char byte = 0;
  iovec here{&byte, 1}, there{&byte, 1};
  return kill(process, 0) == 0 || ptrace(PTRACE_ATTACH, process, nullptr, nullptr) == 0 ||
         process_vm_readv(process, &here, 1, &there, 1, 0) == 1 ||
         canOpen("/proc/" + std::to_string(process) + "/environ", O_RDONLY) ||
         canOpen("/proc/" + std::to_string(process) + "/mem", O_RDONLY);
}

bool seesEnvironment() {
  return std::getenv("HOME") || std::getenv("USER") || std::getenv("PATHMARK_CANARY_SECRET");
}

bool hasStrayDescriptor() {
  for (int fd = kWorkerCrashPipe + 1; fd < 64; ++fd)
    if (fcntl(fd, F_GETFD) >= 0) return true;
  return false;
}

bool canConnect() {
  for (const int family : {AF_INET, AF_INET6, AF_UNIX, AF_NETLINK, AF_VSOCK})
    if (const int fd = socket(family, SOCK_STREAM, 0); fd >= 0) return true;
  return false;
}

bool canLiftLimits() {
  const rlimit limit{RLIM_INFINITY, RLIM_INFINITY};
  return setrlimit(RLIMIT_NPROC, &limit) == 0;
}

bool attempt(char what, const CanaryTask& task) {
  const std::string outside = task.outside, scratch = task.scratch;
  switch (what) {
    case 'r':
      return canOpen(outside + "/canary", O_RDONLY) || canOpen("/etc/passwd", O_RDONLY);
    case 'w':
      return canOpen(outside + "/canary", O_WRONLY) ||
             canOpen(outside + "/left", O_WRONLY | O_CREAT) ||
             canOpen("/usr/pathmark-left", O_WRONLY | O_CREAT);
    case 'n':
      return canConnect();
    case 'e':
      return seesEnvironment();
    case 'p':
      return canReachProcess(task.process);
    case 'd':
      return hasStrayDescriptor();
    case 'l':
      return canLiftLimits();
    case 'u':
      return syscall(SYS_unshare, 0x10000000) == 0;
    case 'f':
      return canFork();
    case 't':
      return canStartThread();
    case 's':
      return !scratch.empty() && canOpen(scratch + "/made", O_WRONLY | O_CREAT);
    default:
      return false;
  }
}

}  // namespace

}  // namespace pathmark::sandbox

int main(int count, char** arguments) {
  using namespace pathmark::sandbox;
  struct sigaction action {};
  action.sa_sigaction = refuse;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGSYS, &action, nullptr);
  CanaryTask task;
  const bool tool = count == 4;
  if (tool) {
    std::strncpy(task.outside, arguments[1], sizeof task.outside - 1);
    std::strncpy(task.scratch, arguments[2], sizeof task.scratch - 1);
    task.process = std::atoi(arguments[3]);
  } else if (read(pathmark::kWorkerSocket, &task, sizeof task) != sizeof task) {
    return EXIT_FAILURE;
  }
  std::string answers;
  for (const char what : kAttempts) answers += attempt(what, task) ? 'y' : 'n';
  const int to = tool ? STDOUT_FILENO : pathmark::kWorkerSocket;
  return write(to, answers.data(), answers.size()) == static_cast<ssize_t>(answers.size())
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
