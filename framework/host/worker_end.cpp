#include "host/worker_end.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

// The last of the numbers is that of the innermost namespace.
std::optional<int> innermostNumber(const fs::path& status) {
  std::ifstream in(status);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("NSpid:")) continue;
    std::istringstream numbers(line.substr(6));
    std::optional<int> last;
    for (int number; numbers >> number;) last = number;
    return last;
  }
  return std::nullopt;
}

}  // namespace

WorkerEnd endOf(int status, bool relayed) {
  if (WIFSIGNALED(status)) return {WTERMSIG(status), 0};
  const int code = WEXITSTATUS(status);
  if (relayed && code > 128) return {code - 128, 0};
  return {std::nullopt, code};
}

WorkerFault faultOf(const CrashRecord& record) {
  if (record.kind == CrashKind::kForbiddenCall) return WorkerFault::kForbiddenCall;
  const bool outOfMemory = record.kind == CrashKind::kException &&
                           std::string_view(record.text).starts_with("std::bad_alloc");
  return outOfMemory ? WorkerFault::kMemoryLimit : WorkerFault::kCrashed;
}

// Nobody but the host and the operating system sends SIGKILL, and the host knows when it does.
WorkerFault faultOfSignal(int signal) {
  switch (signal) {
    case SIGKILL:
      return WorkerFault::kMemoryLimit;
    case SIGSYS:
      return WorkerFault::kForbiddenCall;
    case SIGXCPU:
      return WorkerFault::kTimeLimit;
    default:
      return WorkerFault::kCrashed;
  }
}

std::optional<pid_t> threadNumber(pid_t process, int inner) {
  std::error_code error;
  const fs::path tasks = "/proc/" + std::to_string(process) + "/task";
  for (const auto& task : fs::directory_iterator(tasks, error))
    if (innermostNumber(task.path() / "status") == inner)
      return std::atoi(task.path().filename().c_str());
  return std::nullopt;
}

void killInner(const FileDescriptor& handle) {
  if (handle.get() >= 0) syscall(SYS_pidfd_send_signal, handle.get(), SIGKILL, nullptr, 0);
}

}  // namespace pathmark
