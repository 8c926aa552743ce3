#include "sandbox/shut_in.h"

#include "host/build_config.h"
#include "worker/protocol.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace pathmark::sandbox {

namespace fs = std::filesystem;

namespace {

constexpr rlim_t kStackBytes = rlim_t{8} << 20;
constexpr rlim_t kWorkerThreads = 512;       // 256 render, and Embree has its own
constexpr rlim_t kToolProcesses = 128;       // linkers have threads
constexpr std::size_t kOthersMargin = 4096;  // that the same user may start meanwhile
constexpr rlim_t kWorkerSeconds = 3600;
// A worker can write no files; bubblewrap makes a copy of its program.
constexpr rlim_t kProgramBytes = rlim_t{256} << 20;

// The kernel counts those of the user, which are the program's own only where it has a user of its
// own.
std::size_t processesBeside(std::optional<uid_t> user) {
  return isShared(user) ? processesOfUser(user.value_or(getuid())) + kOthersMargin : 0;
}

void allowMemory(std::vector<Limit>& limits, std::size_t bytes) {
  // Sanitizers reserve far more address space than they use.
  if (!build::kSanitized) limits.push_back({RLIMIT_AS, bytes});
}

}  // namespace

ShutIn::ShutIn(const Limits& limits)
    : limits_(limits), otherProcesses_(processesBeside(nextUser())) {}

fs::path ShutIn::visible(const fs::path& path) { return staging_.visible(path); }

fs::path ShutIn::makeScratchFolder() { return staging_.makeScratchFolder(); }

std::vector<Limit> ShutIn::workerLimits(std::size_t memoryBytes) const {
  std::vector<Limit> limits{{RLIMIT_CORE, 0},
                            {RLIMIT_STACK, kStackBytes},
                            {RLIMIT_FSIZE, kProgramBytes},
                            {RLIMIT_NOFILE, 64},
                            {RLIMIT_MEMLOCK, 0},
                            {RLIMIT_CPU, kWorkerSeconds},
                            {RLIMIT_NPROC, kWorkerThreads + otherProcesses_}};
  allowMemory(limits, memoryBytes);
  return limits;
}

std::vector<Limit> ShutIn::toolLimits(double seconds) const {
  std::vector<Limit> limits{{RLIMIT_CORE, 0},
                            {RLIMIT_STACK, 8 * kStackBytes},
                            {RLIMIT_FSIZE, limits_.fileBytes},
                            {RLIMIT_NOFILE, 512},
                            {RLIMIT_CPU, static_cast<rlim_t>(std::ceil(seconds))},
                            {RLIMIT_NPROC, kToolProcesses + otherProcesses_}};
  allowMemory(limits, limits_.toolBytes);
  return limits;
}

ProcessResult ShutIn::run(const Step& step) {
  ProcessRequest request = step.request;
  request.timeLimitSeconds = std::min(request.timeLimitSeconds, limits_.toolSeconds);
  Launch launch;
  launch.scratch = step.scratch;
  launch.readable = step.readable;
  launch.plan.arguments = request.arguments;
  launch.plan.environment = {"PATH=/usr/bin:/bin", "LC_ALL=C"};
  if (!step.scratch.empty()) launch.plan.environment.push_back("TMPDIR=" + step.scratch.string());
  launch.plan.limits = toolLimits(request.timeLimitSeconds);
  launch.plan.user = nextUser();
  if (launch.plan.user && !step.scratch.empty()) {
    if (chown(step.scratch.c_str(), *launch.plan.user, *launch.plan.user) != 0)
      throw std::system_error(errno, std::generic_category(), "a folder for the sandbox");
    // What an earlier step has left belongs to that step's user.
    for (const auto& file : fs::directory_iterator(step.scratch))
      if (lchown(file.path().c_str(), *launch.plan.user, *launch.plan.user) != 0)
        throw std::system_error(errno, std::generic_category(), "a folder for the sandbox");
  }
  Started started;
  const ProcessResult result = runProcess(request, [&](int in, int out) {
    launch.plan.descriptors = {{in, STDIN_FILENO}, {out, STDOUT_FILENO}, {out, STDERR_FILENO}};
    started = start(std::move(launch));
    return started.pid;
  });
  if (!result.timedOut && !result.stopped && started.startFailure)
    if (const std::string failure = started.startFailure(); !failure.empty())
      throw ConfinementError(failure + " " + result.output.substr(0, 500));
  return result;
}

LaunchedWorker ShutIn::launch(const fs::path& program, std::size_t memoryBytes) {
  WorkerChannels channels;
  const FileDescriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));
  Launch launch;
  launch.worker = true;
  launch.program = program;
  launch.plan.arguments = {"worker"};
  if (!build::kSanitized) launch.plan.arguments.emplace_back(kLockArgument);
  launch.plan.limits = workerLimits(memoryBytes);
  launch.plan.user = nextUser();
  launch.plan.descriptors = {{nothing.get(), STDIN_FILENO},
                             {channels.workerText.get(), STDOUT_FILENO},
                             {channels.workerText.get(), STDERR_FILENO},
                             {channels.workerSocket.get(), kWorkerSocket},
                             {channels.workerCrash.get(), kWorkerCrashPipe}};
  Started started = start(std::move(launch));
  LaunchedWorker launched;
  launched.pid = started.pid;
  launched.inner = started.inner;
  launched.innerHandle = std::move(started.innerHandle);
  launched.startFailure = std::move(started.startFailure);
  launched.socket = std::move(channels.socket);
  launched.text = std::move(channels.text);
  launched.crash = std::move(channels.crash);
  return launched;
}

std::vector<fs::path> systemFiles(bool worker) {
  std::vector<fs::path> files{"/etc/ld.so.cache"};
  if (worker) {
    for (const char* folder : {"/usr/lib", "/usr/lib64", "/lib", "/lib64"})
      files.emplace_back(folder);
  } else {
    for (const char* folder : {"/usr", "/lib", "/lib64", "/bin", "/etc/alternatives"})
      files.emplace_back(folder);
  }
  // Tools and libraries that are not the system's.
  const auto add = [&](std::string_view tool) {
    const fs::path folder = fs::path(tool).parent_path();
    if (folder.is_absolute() && *++folder.begin() != "usr" && *++folder.begin() != "lib" &&
        *++folder.begin() != "bin")
      files.push_back(folder);
  };
  add(build::kEmbree);
  if (!worker)
    for (const std::string_view tool :
         {build::kCompiler, build::kLd, build::kObjcopy, build::kAddr2line})
      add(tool);
  return files;
}

}  // namespace pathmark::sandbox
