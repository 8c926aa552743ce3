#include "host/worker_launch.h"

#include "host/build_config.h"
#include "worker/protocol.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pathmark {

namespace {

std::pair<FileDescriptor, FileDescriptor> makePair(bool socket) {
  std::array<int, 2> ends{};
  const int failed = socket ? socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data())
                            : pipe2(ends.data(), O_CLOEXEC);
  if (failed != 0)
    throw std::system_error(errno, std::generic_category(), "a channel to the worker");
  return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

void setLimit(decltype(RLIMIT_CORE) what, rlim_t value) {
  const rlimit limit{value, value};
  setrlimit(what, &limit);
}

constexpr rlim_t kStackBytes = rlim_t{8} << 20;

// Several workers run side by side, and each may have half of the memory. The system prefers what
// has the highest number; anybody may raise his own.
void offerToBeKilled() {
  const int file = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
  if (file < 0) return;
  [[maybe_unused]] const ssize_t written = write(file, "1000", 4);
  close(file);
}

// Between fork and exec: calls that are safe there, and nothing else.
[[noreturn]] void becomeWorker(const char* program, int socket, int text, int crash,
                               std::size_t memoryBytes, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  placeWorkerDescriptors(socket, text, crash);
  close_range(kWorkerCrashPipe + 1, ~0u, 0);
  offerToBeKilled();
  setLimit(RLIMIT_CORE, 0);
  setLimit(RLIMIT_STACK, kStackBytes);
  // Sanitizers reserve far more address space than they use.
  if (!build::kSanitized) setLimit(RLIMIT_AS, memoryBytes);
  execl(program, "worker", static_cast<char*>(nullptr));
  _exit(127);
}

}  // namespace

WorkerChannels::WorkerChannels() {
  std::tie(socket, workerSocket) = makePair(true);
  std::tie(text, workerText) = makePair(false);
  std::tie(crash, workerCrash) = makePair(false);
}

std::size_t memoryForWorker() {
  constexpr std::size_t kLeast = std::size_t{1} << 30, kMost = std::size_t{8} << 30;
  const long pages = sysconf(_SC_PHYS_PAGES), bytes = sysconf(_SC_PAGE_SIZE);
  if (pages <= 0 || bytes <= 0) return kMost;
  const std::size_t half = static_cast<std::size_t>(pages) / 2 * static_cast<std::size_t>(bytes);
  return std::clamp(half, kLeast, kMost);
}

void placeWorkerDescriptors(int socket, int text, int crash) {
  // First out of the way of the numbers that the worker expects.
  constexpr int kHigh = 64;
  const int high[] = {fcntl(socket, F_DUPFD_CLOEXEC, kHigh), fcntl(text, F_DUPFD_CLOEXEC, kHigh),
                      fcntl(crash, F_DUPFD_CLOEXEC, kHigh)};
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(nothing, STDIN_FILENO);
  dup2(high[1], STDOUT_FILENO);
  dup2(high[1], STDERR_FILENO);
  dup2(high[0], kWorkerSocket);
  dup2(high[2], kWorkerCrashPipe);
}

LaunchedWorker launchWorker(const std::filesystem::path& program, std::size_t memoryBytes) {
  WorkerChannels channels;
  const std::string name = program.string();
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "starting the worker");
  if (child == 0)
    becomeWorker(name.c_str(), channels.workerSocket.get(), channels.workerText.get(),
                 channels.workerCrash.get(), memoryBytes, parent);
  setpgid(child, child);
  LaunchedWorker launched;
  launched.pid = child;
  launched.socket = std::move(channels.socket);
  launched.text = std::move(channels.text);
  launched.crash = std::move(channels.crash);
  return launched;
}

}  // namespace pathmark
