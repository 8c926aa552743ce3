#include "bench/child_process.h"

#include "host/interrupt.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <map>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pathmark::bench {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

pid_t start(const std::vector<std::string>& arguments, const fs::path& log) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::vector<char*> words;
  words.reserve(arguments.size() + 1);
  for (const std::string& a : arguments) words.push_back(const_cast<char*>(a.c_str()));
  words.push_back(nullptr);
  pid_t child = -1;
  const int error = posix_spawnp(&child, words[0], &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::system_error(error, std::generic_category(), arguments.front());
  return child;
}

int exitCodeOf(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

// Leaves the ended child to be asked for, so that its number is nobody else's.
bool hasEnded(pid_t child, int flags) {
  siginfo_t info{};
  while (waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT | flags) < 0 &&
         errno == EINTR) {
  }
  return info.si_pid == child;
}

// 0 when the process has gone.
std::uint64_t peakOf(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("VmHWM:")) return std::stoull(line.substr(6)) << 10;
  return 0;
}

std::vector<pid_t> childrenOf(pid_t process) {
  const std::string name = std::to_string(process);
  std::ifstream in("/proc/" + name + "/task/" + name + "/children");
  std::vector<pid_t> children;
  for (pid_t child = 0; in >> child;) children.push_back(child);
  return children;
}

}  // namespace

ChildUsage runMeasured(const std::vector<std::string>& arguments, const fs::path& log) {
  const Clock::time_point started = Clock::now();
  const pid_t child = start(arguments, log);
  {
    const InterruptsToo interrupts(child);
    hasEnded(child, 0);
  }
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  const std::chrono::duration<double> wall = Clock::now() - started;
  return {exitCodeOf(status), wall.count(), seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

PeakMemory measureMemory(const std::vector<std::string>& arguments, const fs::path& log) {
  const pid_t child = start(arguments, log);
  PeakMemory peak;
  std::map<pid_t, std::uint64_t> peaks;
  {
    const InterruptsToo interrupts(child);
    while (!hasEnded(child, WNOHANG)) {
      peak.program = std::max(peak.program, peakOf(child));
      for (const pid_t grandchild : childrenOf(child))
        peaks[grandchild] = std::max(peaks[grandchild], peakOf(grandchild));
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  peak.exitCode = exitCodeOf(status);
  for (const auto& [pid, bytes] : peaks) peak.children += bytes;
  return peak;
}

}  // namespace pathmark::bench
