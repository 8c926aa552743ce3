#include "sandbox/self_test.h"

#include "host/workshop.h"
#include "sandbox/canary.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pathmark::sandbox {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kSecret = "nobody may read this";

std::string contentOf(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A folder outside, with a file in it that everybody on this machine might read and write.
class Outside {
 public:
  Outside() : folder_(nullptr) {
    fs::permissions(folder_.path(), fs::perms::all);
    std::ofstream(folder_ / "canary") << kSecret;
    fs::permissions(folder_ / "canary", fs::perms::all);
  }
  std::string path() const { return folder_.path().string(); }
  bool untouched() const {
    return contentOf(folder_ / "canary") == kSecret &&
           std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator{}) == 1;
  }

 private:
  ScratchFolder folder_;
};

// What is wrong with the answers.
std::string judge(std::string_view answers, std::string_view must, std::string_view program) {
  if (answers.size() != kAttempts.size()) return fmt::format("{} did not come to its end", program);
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const char what = kAttempts[k];
    const bool wanted = must.find(what) != std::string_view::npos;
    // The scratch folder is none of a worker's concern, and it has been told of none.
    if ((answers[k] == 'y') != wanted)
      return fmt::format("{} of {} {}", attemptInWords(what), program,
                         wanted ? "does not work" : "is possible");
  }
  return {};
}

std::string testTool(Confinement& confinement, const Outside& outside) {
  const ScratchFolder scratch(&confinement);
  const fs::path canary = confinement.visible(PATHMARK_CANARY);
  ProcessRequest request;
  request.arguments = {canary.string(), outside.path(), scratch.path().string(),
                       std::to_string(getpid())};
  request.timeLimitSeconds = 20.0;
  const ProcessResult result = confinement.run({request, scratch.path(), {canary}});
  return judge(result.output, kToolMust, "a tool");
}

std::string testWorker(Confinement& confinement, const Outside& outside) {
  LaunchedWorker worker = confinement.launch(PATHMARK_CANARY, std::size_t{1} << 30);
  CanaryTask task;
  std::strncpy(task.outside, outside.path().c_str(), sizeof task.outside - 1);
  task.process = getpid();
  std::string answers;
  if (send(worker.socket.get(), &task, sizeof task, MSG_NOSIGNAL) == sizeof task) {
    pollfd ready{worker.socket.get(), POLLIN, 0};
    while (answers.size() < kAttempts.size() && poll(&ready, 1, 20000) > 0) {
      std::array<char, 64> chunk{};
      const ssize_t n = recv(worker.socket.get(), chunk.data(), chunk.size(), 0);
      if (n <= 0) break;
      answers.append(chunk.data(), static_cast<std::size_t>(n));
    }
  }
  kill(-worker.pid, SIGKILL);
  while (waitpid(worker.pid, nullptr, 0) < 0 && errno == EINTR) {
  }
  return judge(answers, kWorkerMust, "a worker");
}

}  // namespace

std::string selfTest(Confinement& confinement) {
  // For the canaries to look for.
  setenv("PATHMARK_CANARY_SECRET", "1", 1);
  const Outside outside;
  std::string failure = testWorker(confinement, outside);
  if (failure.empty()) failure = testTool(confinement, outside);
  if (failure.empty() && !outside.untouched()) failure = "a file outside was changed";
  unsetenv("PATHMARK_CANARY_SECRET");
  return failure;
}

}  // namespace pathmark::sandbox
