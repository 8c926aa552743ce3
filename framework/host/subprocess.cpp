#include "host/subprocess.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pathmark {

namespace {

using Clock = std::chrono::steady_clock;

struct Pipe {
  int read = -1, write = -1;

  Pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
      throw std::system_error(errno, std::generic_category(), "pipe");
    read = ends[0];
    write = ends[1];
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    closeRead();
    closeWrite();
  }
  void closeRead() {
    if (read >= 0) close(read);
    read = -1;
  }
  void closeWrite() {
    if (write >= 0) close(write);
    write = -1;
  }
};

pid_t spawn(const ProcessRequest& request, int in, int out) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out, STDERR_FILENO);
  if (!request.folder.empty())
    posix_spawn_file_actions_addchdir_np(&actions, request.folder.c_str());
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);

  std::vector<char*> arguments;
  for (const std::string& a : request.arguments) arguments.push_back(const_cast<char*>(a.c_str()));
  arguments.push_back(nullptr);
  pid_t child = -1;
  const int error =
      posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    throw std::system_error(error, std::generic_category(), request.arguments.front());
  return child;
}

int millisecondsUntil(Clock::time_point deadline) {
  const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::max<std::int64_t>(left, 0));
}

// Feeds the input and collects the output until the child closes its end or time is up.
bool exchange(const ProcessRequest& request, Clock::time_point deadline, Pipe& in, Pipe& out,
              std::string& output) {
  std::size_t sent = 0;
  fcntl(in.write, F_SETFL, O_NONBLOCK);
  if (request.input.empty()) in.closeWrite();
  for (;;) {
    const int left = millisecondsUntil(deadline);
    if (left == 0) return false;
    std::array<pollfd, 2> fds{{{out.read, POLLIN, 0}, {in.write, POLLOUT, 0}}};
    if (poll(fds.data(), fds.size(), left) < 0 && errno != EINTR) return false;
    if (fds[1].revents != 0) {
      const ssize_t n = write(in.write, request.input.data() + sent, request.input.size() - sent);
      if (n > 0) sent += static_cast<std::size_t>(n);
      if ((n < 0 && errno != EAGAIN && errno != EINTR) || sent == request.input.size())
        in.closeWrite();
    }
    if (fds[0].revents != 0) {
      std::array<char, 16384> chunk{};
      const ssize_t n = read(out.read, chunk.data(), chunk.size());
      if (n == 0) return true;
      if (n < 0 && errno != EINTR) return true;
      if (n > 0 && output.size() < request.outputLimit)
        output.append(chunk.data(),
                      std::min(static_cast<std::size_t>(n), request.outputLimit - output.size()));
    }
  }
}

}  // namespace

bool awaitEnd(pid_t child, Clock::time_point deadline) {
  siginfo_t info{};
  for (;;) {
    if (waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        info.si_pid != 0)
      return true;
    if (millisecondsUntil(deadline) == 0) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

ProcessResult runProcess(const ProcessRequest& request) {
  return runProcess(request, [&](int in, int out) { return spawn(request, in, out); });
}

ProcessResult runProcess(const ProcessRequest& request, const StartProcess& start) {
  // A child that ends before it has read its input must not end this process.
  signal(SIGPIPE, SIG_IGN);
  Pipe in, out;
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(request.timeLimitSeconds));
  const pid_t child = start(in.read, out.write);
  in.closeRead();
  out.closeWrite();
  ProcessResult result;
  result.timeLimitSeconds = request.timeLimitSeconds;
  // One may close its output and go on.
  result.timedOut =
      !exchange(request, deadline, in, out, result.output) || !awaitEnd(child, deadline);
  kill(-child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

}  // namespace pathmark
