#include "sandbox/child.h"

#include "host/confinement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <linux/capability.h>
#include <linux/seccomp.h>
#include <linux/securebits.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sandbox/landlock.h"

namespace pathmark::sandbox {

namespace {

constexpr int kHigh = 100;  // above all numbers that are given
constexpr int kReport = 90;

enum class Stage : int { kDescriptors, kLimits, kUser, kRules, kFilter, kExec };

constexpr std::array<const char*, 6> kStageNames{
    "its descriptors",        "its limits",  "its user", "its Landlock rules",
    "its system call filter", "executing it"};

struct Failure {
  Stage stage;
  int error;
};

[[noreturn]] void give(Stage stage) {
  const Failure failure{stage, errno};
  [[maybe_unused]] const ssize_t n = write(kReport, &failure, sizeof failure);
  _exit(127);
}

void placeDescriptors(const ChildPlan& plan, int report, int& program, int& rules) {
  std::array<int, 16> high{};
  std::size_t k = 0;
  for (const ChildPlan::Placed& d : plan.descriptors)
    high.at(k++) = fcntl(d.here, F_DUPFD_CLOEXEC, kHigh);
  if (program >= 0) program = fcntl(program, F_DUPFD_CLOEXEC, kHigh);
  if (rules >= 0) rules = fcntl(rules, F_DUPFD_CLOEXEC, kHigh);
  dup3(fcntl(report, F_DUPFD_CLOEXEC, kHigh), kReport, O_CLOEXEC);
  k = 0;
  int largest = 2;
  for (const ChildPlan::Placed& d : plan.descriptors) {
    if (dup2(high[k++], d.there) < 0) give(Stage::kDescriptors);
    largest = std::max(largest, d.there);
  }
  // Numbers that were not given close with exec, and these were no-one's to give.
  close_range(static_cast<unsigned>(largest) + 1, ~0u, CLOSE_RANGE_CLOEXEC);
  for (int fd = 3; fd <= largest; ++fd)
    if (std::none_of(plan.descriptors.begin(), plan.descriptors.end(),
                     [&](const ChildPlan::Placed& d) { return d.there == fd; }))
      close(fd);
}

// System calls themselves: the C library's functions would speak to threads that are not there.
bool becomeUser(uid_t user) {
  return syscall(SYS_setgroups, 0, nullptr) == 0 && syscall(SYS_setresgid, user, user, user) == 0 &&
         syscall(SYS_setresuid, user, user, user) == 0;
}

// What is root's then is what root owns: Landlock rules over files, and nothing else is left.
bool giveUpCapabilities() {
  for (unsigned long capability = 0; prctl(PR_CAPBSET_READ, capability, 0, 0, 0) >= 0; ++capability)
    if (prctl(PR_CAPBSET_DROP, capability, 0, 0, 0) != 0) return false;
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  const std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> nothing{};
  return prctl(PR_SET_SECUREBITS, SECBIT_NOROOT | SECBIT_NOROOT_LOCKED, 0, 0, 0) == 0 &&
         syscall(SYS_capset, &header, nothing.data()) == 0;
}

// Where memory runs out, this process is the one to end.
void offerToBeKilled() {
  const int file = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
  if (file < 0) return;
  [[maybe_unused]] const ssize_t n = write(file, "1000", 4);
  close(file);
}

struct Strings {
  explicit Strings(const std::vector<std::string>& strings) {
    for (const std::string& s : strings) pointers.push_back(const_cast<char*>(s.c_str()));
    pointers.push_back(nullptr);
  }
  std::vector<char*> pointers;
};

[[noreturn]] void become(const ChildPlan& plan, CallFilter& filter, char* const* arguments,
                         char* const* environment, int report, pid_t parent) {
  setpgid(0, 0);
  umask(022);
  for (const int signal : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGQUIT}) ::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  int program = plan.program, rules = plan.rules;
  placeDescriptors(plan, report, program, rules);
  offerToBeKilled();
  for (const Limit& limit : plan.limits) {
    const rlimit both{limit.value, limit.value};
    if (setrlimit(limit.what, &both) != 0) give(Stage::kLimits);
  }
  if (plan.user && !becomeUser(*plan.user)) give(Stage::kUser);
  if (plan.powerless && !plan.user && geteuid() == 0 && !giveUpCapabilities()) give(Stage::kUser);
  // After the change of user, which forgets it.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  if (chdir(plan.folder.c_str()) != 0) give(Stage::kDescriptors);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  if (rules >= 0 && !obeyRules(rules)) give(Stage::kRules);
  if (!filter.empty()) {
    for (sock_filter& step : filter)
      if (step.k == kOwnProcess) step.k = static_cast<std::uint32_t>(getpid());
    const sock_fprog code{static_cast<unsigned short>(filter.size()), filter.data()};
    if (syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &code) != 0) give(Stage::kFilter);
  }
  if (program >= 0)
    syscall(SYS_execveat, program, "", arguments, environment, AT_EMPTY_PATH);
  else
    execve(arguments[0], arguments, environment);
  give(Stage::kExec);
}

}  // namespace

pid_t startChild(const ChildPlan& plan) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "pipe");
  const FileDescriptor told(ends[0]);
  FileDescriptor report(ends[1]);
  const Strings arguments(plan.arguments), environment(plan.environment);
  CallFilter filter = plan.filter;
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "starting a process");
  if (child == 0)
    become(plan, filter, arguments.pointers.data(), environment.pointers.data(), report.get(),
           parent);
  setpgid(child, child);
  report.reset();
  Failure failure{};
  ssize_t n = 0;
  while ((n = read(told.get(), &failure, sizeof failure)) < 0 && errno == EINTR) {
  }
  if (n != sizeof failure) return child;
  while (waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
  }
  throw ConfinementError(fmt::format(
      "{} could not be started in the sandbox: {} failed ({}).", plan.arguments.front(),
      kStageNames.at(static_cast<std::size_t>(failure.stage)), std::strerror(failure.error)));
}

}  // namespace pathmark::sandbox
