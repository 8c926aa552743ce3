#include "host/subprocess.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>

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

pid_t spawn(const ProcessRequest& request, const Pipe& in, const Pipe& out) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.read, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.write, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.write, STDERR_FILENO);
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

// Feeds the input and collects the output until the child closes its end or time is up.
bool exchange(const ProcessRequest& request, Pipe& in, Pipe& out, std::string& output) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(request.timeLimitSeconds));
  std::size_t sent = 0;
  fcntl(in.write, F_SETFL, O_NONBLOCK);
  if (request.input.empty()) in.closeWrite();
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return false;
    std::array<pollfd, 2> fds{{{out.read, POLLIN, 0}, {in.write, POLLOUT, 0}}};
    if (poll(fds.data(), fds.size(), static_cast<int>(left)) < 0 && errno != EINTR) return false;
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

ProcessResult runProcess(const ProcessRequest& request) {
  // A child that ends before it has read its input must not end this process.
  signal(SIGPIPE, SIG_IGN);
  Pipe in, out;
  const pid_t child = spawn(request, in, out);
  in.closeRead();
  out.closeWrite();
  ProcessResult result;
  if (!exchange(request, in, out, result.output)) {
    result.timedOut = true;
    kill(-child, SIGKILL);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

}  // namespace pathmark
