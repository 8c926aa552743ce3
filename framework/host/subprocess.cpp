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

// How long to wait for a process.
class Patience {
 public:
  explicit Patience(const ProcessRequest& request)
      : goOn_(request.goOn),
        deadline_(Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                     std::chrono::duration<double>(request.timeLimitSeconds))) {}

  bool mayGoOn() const { return !goOn_ || goOn_(); }
  bool ends() const { return millisecondsUntil(deadline_) == 0 || !mayGoOn(); }

  // Until the deadline, or until it is to be asked again whether to go on.
  int milliseconds() const {
    constexpr int kBetweenQuestions = 100;
    const int left = millisecondsUntil(deadline_);
    return goOn_ ? std::min(left, kBetweenQuestions) : left;
  }

 private:
  const std::function<bool()>& goOn_;
  Clock::time_point deadline_;
};

// Feeds the input and collects the output until the child closes its end or patience ends.
bool exchange(const ProcessRequest& request, const Patience& patience, Pipe& in, Pipe& out,
              std::string& output) {
  std::size_t sent = 0;
  fcntl(in.write, F_SETFL, O_NONBLOCK);
  if (request.input.empty()) in.closeWrite();
  for (;;) {
    if (patience.ends()) return false;
    std::array<pollfd, 2> fds{{{out.read, POLLIN, 0}, {in.write, POLLOUT, 0}}};
    if (poll(fds.data(), fds.size(), patience.milliseconds()) < 0 && errno != EINTR) return false;
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

// Leaves the child to be waited for.
bool awaitEndUnless(pid_t child, const std::function<bool()>& waitingEnds) {
  siginfo_t info{};
  for (;;) {
    if (waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        info.si_pid != 0)
      return true;
    if (waitingEnds()) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

}  // namespace

bool awaitEnd(pid_t child, Clock::time_point deadline) {
  return awaitEndUnless(child, [&] { return millisecondsUntil(deadline) == 0; });
}

ProcessResult runProcess(const ProcessRequest& request) {
  return runProcess(request, [&](int in, int out) { return spawn(request, in, out); });
}

ProcessResult runProcess(const ProcessRequest& request, const StartProcess& start) {
  // A child that ends before it has read its input must not end this process.
  signal(SIGPIPE, SIG_IGN);
  Pipe in, out;
  const Patience patience(request);
  const pid_t child = start(in.read, out.write);
  in.closeRead();
  out.closeWrite();
  ProcessResult result;
  result.timeLimitSeconds = request.timeLimitSeconds;
  // One may close its output and go on.
  const bool ended = exchange(request, patience, in, out, result.output) &&
                     awaitEndUnless(child, [&] { return patience.ends(); });
  result.stopped = !ended && !patience.mayGoOn();
  result.timedOut = !ended && !result.stopped;
  kill(-child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

}  // namespace pathmark
