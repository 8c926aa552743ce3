#include "worker/crash_handler.h"

#include "worker/forbidden_call.h"
#include "worker/lock.h"
#include "worker/protocol.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <typeinfo>

#include <cxxabi.h>
#include <execinfo.h>
#include <pthread.h>
#include <signal.h>
#include <sys/resource.h>
#include <ucontext.h>
#include <unistd.h>

// Where the linker put the start of the program.
extern "C" const char __executable_start;  // NOLINT(bugprone-reserved-identifier)

namespace pathmark {

namespace {

constexpr std::size_t kSignalStackBytes = std::size_t{64} << 10;
constexpr std::uintptr_t kGuardBytes = std::uintptr_t{1} << 20;  // around the end of a stack

struct ThreadStack {
  std::unique_ptr<std::byte[]> signalStack;
  std::uintptr_t lowest = 0;

  ~ThreadStack() {
    stack_t off{};
    off.ss_flags = SS_DISABLE;
    sigaltstack(&off, nullptr);
  }
};

// Handlers have no arguments of their own: what they need is per thread or per process.
thread_local ThreadStack threadStack;
std::atomic_flag reported;
std::atomic<bool> finished{false};
thread_local bool exiting = false;

std::uintptr_t instructionPointer(const void* context) {
  [[maybe_unused]] const auto* uc = static_cast<const ucontext_t*>(context);
#if defined(__x86_64__)
  return static_cast<std::uintptr_t>(uc->uc_mcontext.gregs[REG_RIP]);
#elif defined(__aarch64__)
  return uc->uc_mcontext.pc;
#else
  return 0;
#endif
}

// The frames from `start` outwards; all of them if it is not among them.
void fillFrames(CrashRecord& record, std::uintptr_t start) {
  void* addresses[CrashRecord::kMaxFrames + 8];
  const int found = backtrace(addresses, static_cast<int>(std::size(addresses)));
  void** const end = addresses + found;
  void** first = std::find(addresses, end, reinterpret_cast<void*>(start));
  const bool known = first != end;
  if (!known) first = addresses;
  const auto base = reinterpret_cast<std::uintptr_t>(&__executable_start);
  for (void** a = first; a != end && record.frameCount < CrashRecord::kMaxFrames; ++a) {
    // A return address lies behind its call; the address of the fault is made to look like one.
    const std::uintptr_t exact = known && a == first ? 1 : 0;
    record.frames[record.frameCount++] = reinterpret_cast<std::uintptr_t>(*a) + exact - base;
  }
}

void send(const CrashRecord& record) {
  if (reported.test_and_set()) {
    // Another thread is reporting already and will end the process.
    for (;;) pause();
  }
  [[maybe_unused]] const ssize_t written = write(kWorkerCrashPipe, &record, sizeof record);
}

// The first process of a namespace survives its own signals; it then ends by the worker's lock,
// which refuses _exit with a signal that is blocked.
[[noreturn]] void dieOf(int signal) {
  ::signal(signal, SIG_DFL);
  sigset_t others;
  sigfillset(&others);
  sigdelset(&others, signal);
  pthread_sigmask(SIG_SETMASK, &others, nullptr);
  raise(signal);
  _exit(128 + signal);
}

bool isStackOverflow(int signal, const siginfo_t& info) {
  if (signal != SIGSEGV && signal != SIGBUS) return false;
  const auto address = reinterpret_cast<std::uintptr_t>(info.si_addr);
  const std::uintptr_t lowest = threadStack.lowest;
  return lowest != 0 && address + kGuardBytes >= lowest && address < lowest + kGuardBytes;
}

void onSignal(int signal, siginfo_t* info, void* context) {
  CrashRecord record;
  record.signal = signal;
  if (isForbiddenCall(signal, *info)) {
    if (answerHarmlessCall(*info, context)) return;
    describeCall(record, *info, context);
    // The end of the process, which this thread has reported.
    if (record.kind == CrashKind::kExit && exiting) dieOf(SIGKILL);
  } else if (signal == SIGUSR1)
    record.kind = CrashKind::kWhereabouts;
  else if (isStackOverflow(signal, *info))
    record.kind = CrashKind::kStackOverflow;
  fillFrames(record, instructionPointer(context));
  send(record);
  dieOf(signal == SIGUSR1 ? SIGKILL : signal);
}

void onExit() {
  if (finished) return;
  CrashRecord record;
  record.kind = CrashKind::kExit;
  fillFrames(record, 0);
  send(record);
  exiting = true;
  _exit(EXIT_FAILURE);
}

void onTerminate() {
  CrashRecord record;
  record.kind = CrashKind::kException;
  record.signal = SIGABRT;
  if (const std::exception_ptr thrown = std::current_exception()) {
    try {
      std::rethrow_exception(thrown);
    } catch (const std::exception& e) {
      int status = 0;
      const std::unique_ptr<char, decltype(&std::free)> name(
          abi::__cxa_demangle(typeid(e).name(), nullptr, nullptr, &status), &std::free);
      // Where memory has run out there is none for the name either.
      const char* const known =
          typeid(e) == typeid(std::bad_alloc) ? "std::bad_alloc" : typeid(e).name();
      std::snprintf(record.text, sizeof record.text, "%s: %s", status == 0 ? name.get() : known,
                    e.what());
    } catch (...) {
      std::snprintf(record.text, sizeof record.text, "a value that is no std::exception");
    }
  }
  fillFrames(record, 0);
  send(record);
  dieOf(SIGABRT);
}

}  // namespace

void prepareThreadForCrashes() {
  threadStack.signalStack = std::make_unique<std::byte[]>(kSignalStackBytes);
  stack_t stack{};
  stack.ss_sp = threadStack.signalStack.get();
  stack.ss_size = kSignalStackBytes;
  sigaltstack(&stack, nullptr);

  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) == 0) {
    void* lowest = nullptr;
    std::size_t size = 0;
    pthread_attr_getstack(&attributes, &lowest, &size);
    threadStack.lowest = reinterpret_cast<std::uintptr_t>(lowest);
    pthread_attr_destroy(&attributes);
  } else {
    // The first thread's bounds are in /proc, which a sandbox has none of; this is near its end.
    rlimit limit{};
    getrlimit(RLIMIT_STACK, &limit);
    threadStack.lowest = reinterpret_cast<std::uintptr_t>(&limit) - limit.rlim_cur;
  }
}

namespace {

// Before the constructors of the coursework's own global variables, which may crash too.
[[gnu::constructor(101)]] void installCrashHandlers(int count, char** arguments) {
  // The first call loads the unwinder, which a signal handler must not do.
  void* warmUp[1];
  backtrace(warmUp, 1);

  struct sigaction action {};
  action.sa_sigaction = onSignal;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigfillset(&action.sa_mask);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGUSR1, SIGSYS})
    sigaction(signal, &action, nullptr);
  std::set_terminate(onTerminate);
  std::atexit(onExit);
  prepareThreadForCrashes();
  if (count > 1 && kLockArgument == arguments[1] && !lockWorker()) _exit(EXIT_FAILURE);
}

}  // namespace

void reportExits(int threads) {
  for (int k = 0; k < threads; ++k) std::atexit(onExit);
}

void finishWorker() { finished = true; }

}  // namespace pathmark
