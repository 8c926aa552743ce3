#include "sandbox/bubblewrap_tier.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace pathmark::sandbox {

namespace fs = std::filesystem;

namespace {

// Descriptors that bubblewrap gets besides those of the program.
constexpr int kArguments = 5, kFilter = 6, kProgram = 7, kStatus = 8;
constexpr const char* kWorkerPath = "/worker";
constexpr std::size_t kTemporaryBytes = std::size_t{256} << 20;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

FileDescriptor fileWith(std::span<const std::byte> bytes) {
  FileDescriptor file(memfd_create("sandbox", MFD_CLOEXEC));
  if (file.get() < 0 ||
      write(file.get(), bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()) ||
      lseek(file.get(), 0, SEEK_SET) != 0)
    fail("memory for the sandbox");
  return file;
}

// A list of arguments that may be long: bubblewrap reads it from a descriptor, and nobody sees it
// in the list of processes.
class Arguments {
 public:
  template <class... Words>
  void add(const Words&... words) {
    ((text_ += std::string_view(words), text_ += '\0'), ...);
  }
  FileDescriptor file() const { return fileWith(std::as_bytes(std::span(text_))); }

 private:
  std::string text_;
};

// At its own place. A link of the system such as /lib stays one.
void bindSystem(Arguments& arguments, const fs::path& path) {
  if (fs::is_symlink(path))
    arguments.add("--symlink", fs::read_symlink(path).string(), path.string());
  else
    arguments.add("--ro-bind-try", path.string(), path.string());
}

Arguments wallsOf(const Launch& launch) {
  Arguments a;
  // --unshare-user beside --unshare-all, which only tries it; --disable-userns asks for it.
  a.add("--unshare-all", "--unshare-user", "--disable-userns", "--die-with-parent", "--new-session",
        "--as-pid-1", "--cap-drop", "ALL", "--hostname", "sandbox", "--clearenv");
  a.add("--seccomp", std::to_string(kFilter), "--json-status-fd", std::to_string(kStatus));
  for (const std::string& variable : launch.plan.environment) {
    const std::size_t equals = variable.find('=');
    a.add("--setenv", variable.substr(0, equals), variable.substr(equals + 1));
  }
  for (const fs::path& path : systemFiles(launch.worker)) bindSystem(a, path);
  if (!launch.worker) {
    // In front of what lies below it.
    a.add("--size", std::to_string(kTemporaryBytes), "--tmpfs", "/tmp");
    for (const fs::path& path : launch.readable) a.add("--ro-bind", path.string(), path.string());
    if (!launch.scratch.empty()) a.add("--bind", launch.scratch.string(), launch.scratch.string());
  } else {
    a.add("--perms", "0555", "--ro-bind-data", std::to_string(kProgram), kWorkerPath);
  }
  a.add("--remount-ro", "/", "--chdir", "/");
  return a;
}

// What bubblewrap tells: {"child-pid": 12, ...} when it has forked, {"exit-code": 0} when the
// program has run.
class Status {
 public:
  explicit Status(FileDescriptor file) : file_(std::move(file)) {}

  // Reads until `word` has come, or the end.
  bool await(std::string_view word, std::chrono::milliseconds most) {
    const auto deadline = std::chrono::steady_clock::now() + most;
    while (text_.find(word) == std::string::npos) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
          deadline - std::chrono::steady_clock::now());
      pollfd poll{file_.get(), POLLIN, 0};
      if (left.count() <= 0 || ::poll(&poll, 1, static_cast<int>(left.count())) <= 0) return false;
      std::array<char, 512> chunk{};
      const ssize_t n = read(file_.get(), chunk.data(), chunk.size());
      if (n <= 0) return false;
      text_.append(chunk.data(), static_cast<std::size_t>(n));
    }
    return true;
  }

  int number(std::string_view word) const {
    const std::size_t at = text_.find(word);
    return at == std::string::npos ? -1 : std::atoi(text_.c_str() + at + word.size());
  }

 private:
  FileDescriptor file_;
  std::string text_;
};

constexpr std::string_view kChild = "\"child-pid\":", kExit = "\"exit-code\":";
constexpr std::chrono::milliseconds kPatience{10000}, kNoPatience{200};

}  // namespace

fs::path findBubblewrap() {
  for (const char* folder : {"/usr/bin", "/usr/local/bin", "/bin"})
    if (access((fs::path(folder) / "bwrap").c_str(), X_OK) == 0) return fs::path(folder) / "bwrap";
  return {};
}

BubblewrapTier::BubblewrapTier(const Limits& limits)
    : ShutIn(limits),
      bubblewrap_(findBubblewrap()),
      workerFilter_(workerFilter(false)),
      toolFilter_(toolFilter()) {
  if (bubblewrap_.empty()) throw ConfinementError("bubblewrap (bwrap) is not installed");
}

std::string BubblewrapTier::name() const { return std::string(nameOf(Tier::kBubblewrap)); }

Started BubblewrapTier::start(Launch launch) {
  const FileDescriptor arguments = wallsOf(launch).file();
  const FileDescriptor filter =
      fileWith(std::as_bytes(std::span(launch.worker ? workerFilter_ : toolFilter_)));
  FileDescriptor program;
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("pipe");
  FileDescriptor status(ends[0]), statusThere(ends[1]);
  ChildPlan& plan = launch.plan;
  std::vector<std::string> command{bubblewrap_.string(), "--args", std::to_string(kArguments),
                                   "--"};
  if (launch.worker) {
    program = FileDescriptor(open(launch.program.c_str(), O_RDONLY | O_CLOEXEC));
    if (program.get() < 0) fail(launch.program.c_str());
    plan.descriptors.push_back({program.get(), kProgram});
    plan.arguments.front() = kWorkerPath;
  }
  command.insert(command.end(), plan.arguments.begin(), plan.arguments.end());
  plan.arguments = std::move(command);
  plan.environment.clear();
  plan.descriptors.push_back({arguments.get(), kArguments});
  plan.descriptors.push_back({filter.get(), kFilter});
  plan.descriptors.push_back({statusThere.get(), kStatus});

  Started started;
  started.pid = startChild(plan);
  statusThere.reset();
  const auto told = std::make_shared<Status>(std::move(status));
  if (told->await(kChild, kPatience) && launch.worker) {
    started.inner = told->number(kChild);
    started.innerHandle =
        FileDescriptor(static_cast<int>(syscall(SYS_pidfd_open, started.inner, 0)));
  }
  started.startFailure = [told]() -> std::string {
    return told->await(kExit, kNoPatience) ? "" : "bubblewrap could not start the program.";
  };
  return started;
}

}  // namespace pathmark::sandbox
