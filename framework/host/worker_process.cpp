#include "host/worker_process.h"

#include "host/build_cache.h"
#include "host/build_config.h"
#include "host/crash_sentence.h"
#include "host/message_bytes.h"
#include "host/worker_end.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

#include <poll.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pathmark {

namespace {

constexpr int kPollMilliseconds = 50;

}  // namespace

WorkerProcess::WorkerProcess(Options options) : options_(std::move(options)) {
  // It may be started hours after it was linked.
  markUsed(options_.program.parent_path());
  const std::size_t memory = options_.limits.memoryBytes;
  process_ = options_.confinement ? options_.confinement->launch(options_.program, memory)
                                  : launchWorker(options_.program, memory);
  try {
    const auto started = Clock::now();
    const auto body = awaitReply(MessageKind::kHello, 0, sizeof(Hello), sizeof(Hello),
                                 [&] { return silentFor(started); });
    if (valueOf<Hello>(body).version != kProtocolVersion)
      fail(WorkerFault::kNonsense, "The worker speaks another version of the protocol.");
    greeted_ = true;
  } catch (...) {
    closeAll();
    throw;
  }
}

WorkerProcess::~WorkerProcess() { closeAll(); }

void WorkerProcess::closeAll() {
  process_.socket.reset();
  if (process_.pid > 0) {
    killInner(process_.innerHandle);
    kill(-process_.pid, SIGKILL);
    reap();
  }
  process_.text.reset();
  process_.crash.reset();
}

int WorkerProcess::reap() {
  int status = 0;
  if (process_.pid > 0)
    while (waitpid(process_.pid, &status, 0) < 0 && errno == EINTR) {
    }
  process_.pid = process_.inner = -1;
  return status;
}

std::optional<int> WorkerProcess::silentFor(Clock::time_point since) const {
  const double seconds = std::chrono::duration<double>(Clock::now() - since).count();
  return seconds > options_.limits.secondsWithoutAnswer ? std::optional<int>(kMainThread)
                                                        : std::nullopt;
}

void WorkerProcess::stopIfAsked() {
  if (!options_.goOn || options_.goOn()) return;
  closeAll();
  throw WorkerStopped();
}

std::uint32_t WorkerProcess::sendRequest(MessageKind kind, std::span<const std::byte> body,
                                         int descriptor) {
  if (process_.pid <= 0) throw std::logic_error("the worker has ended");
  MessageHeader header;
  header.kind = kind;
  header.sequence = nextSequence_++;
  header.length = body.size();
  sendBytes(bytesOf(header), descriptor);
  sendBytes(body, -1);
  return header.sequence;
}

void WorkerProcess::sendBytes(std::span<const std::byte> bytes, int descriptor) {
  const auto started = Clock::now();
  while (!bytes.empty()) {
    iovec part{const_cast<std::byte*>(bytes.data()), bytes.size()};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
    if (descriptor >= 0) {
      message.msg_control = control.data();
      message.msg_controllen = control.size();
      cmsghdr* c = CMSG_FIRSTHDR(&message);
      c->cmsg_level = SOL_SOCKET;
      c->cmsg_type = SCM_RIGHTS;
      c->cmsg_len = CMSG_LEN(sizeof(int));
      std::memcpy(CMSG_DATA(c), &descriptor, sizeof descriptor);
    }
    const ssize_t sent = sendmsg(process_.socket.get(), &message, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(sent));
      descriptor = -1;
      continue;
    }
    if (errno == EPIPE || errno == ECONNRESET) failDead();
    if (errno != EAGAIN && errno != EINTR)
      throw std::system_error(errno, std::generic_category(), "sending to the worker");
    pump(kPollMilliseconds, POLLOUT);
    stopIfAsked();
    if (const auto thread = silentFor(started)) failStalled(*thread);
  }
}

// Waits for something to happen; reads what the coursework prints and what a crash says. Returns
// whether the socket is ready.
bool WorkerProcess::pump(int timeoutMilliseconds, short socketEvents) {
  std::array<pollfd, 3> fds{{{process_.socket.get(), socketEvents, 0},
                             {process_.text.get(), POLLIN, 0},
                             {process_.crash.get(), POLLIN, 0}}};
  if (poll(fds.data(), fds.size(), timeoutMilliseconds) < 0) {
    if (errno == EINTR) return false;
    throw std::system_error(errno, std::generic_category(), "waiting for the worker");
  }
  if (fds[1].revents != 0) readText();
  if (fds[2].revents != 0) readCrash();
  return fds[0].revents != 0;
}

void WorkerProcess::readText() {
  std::array<char, 65536> chunk{};
  const ssize_t n = read(process_.text.get(), chunk.data(), chunk.size());
  if (n <= 0) {
    if (n == 0) process_.text.reset();
    return;
  }
  textBytes_ += static_cast<std::size_t>(n);
  if (textBytes_ > options_.limits.outputBytes)
    fail(WorkerFault::kOutputLimit,
         fmt::format("The coursework printed more than {} KiB and was stopped: print less, or only "
                     "for one pixel.",
                     options_.limits.outputBytes / 1024));
  if (options_.onText) options_.onText({chunk.data(), static_cast<std::size_t>(n)});
}

bool WorkerProcess::readCrash() {
  CrashRecord record;
  const ssize_t n = read(process_.crash.get(), &record, sizeof record);
  if (n == 0) process_.crash.reset();
  if (n != sizeof record || record.magic != CrashRecord::kMagic) return false;
  record.text[sizeof record.text - 1] = 0;
  record.frameCount = std::min<std::uint32_t>(record.frameCount, CrashRecord::kMaxFrames);
  crashRecord_ = record;
  return true;
}

std::vector<std::byte> WorkerProcess::awaitReply(
    MessageKind kind, std::uint32_t sequence, std::uint64_t smallest, std::uint64_t largest,
    const std::function<std::optional<int>()>& stalledThread) {
  MessageHeader header;
  std::vector<std::byte> bytes(sizeof header);
  std::size_t got = 0;
  bool haveHeader = false;
  while (!haveHeader || got < bytes.size()) {
    if (haveHeader && bytes.empty()) break;
    stopIfAsked();
    if (const auto thread = stalledThread()) failStalled(*thread);
    if (!pump(kPollMilliseconds, POLLIN)) continue;
    const ssize_t n =
        recv(process_.socket.get(), bytes.data() + got, bytes.size() - got, MSG_DONTWAIT);
    if (n < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (n <= 0) failDead();
    got += static_cast<std::size_t>(n);
    if (haveHeader || got < bytes.size()) continue;
    header = valueOf<MessageHeader>(bytes);
    if (header.magic != kProtocolMagic || header.kind != kind || header.sequence != sequence ||
        header.length < smallest || header.length > largest)
      fail(WorkerFault::kNonsense,
           "The worker gave an answer that does not fit the question: coursework must not write to "
           "files or sockets that it has not opened, nor outside its arrays.");
    haveHeader = true;
    bytes.assign(header.length, std::byte{0});
    got = 0;
  }
  // What was printed before the answer is there already.
  pump(0, 0);
  return bytes;
}

// The socket is closed: the worker is dead or dying, and a crash record may still be on its way.
void WorkerProcess::failDead() {
  const auto deadline = Clock::now() + std::chrono::seconds(2);
  process_.socket.reset();
  while ((process_.text.get() >= 0 || process_.crash.get() >= 0) && Clock::now() < deadline)
    pump(kPollMilliseconds, 0);
  // One that still runs has closed the socket.
  const bool alive = !awaitEnd(process_.pid, deadline + std::chrono::seconds(1));
  const bool relayed = process_.innerHandle.get() >= 0;
  killInner(process_.innerHandle);
  kill(-process_.pid, SIGKILL);
  const WorkerEnd end = endOf(reap(), relayed);
  if (crashRecord_)
    fail(faultOf(*crashRecord_),
         crashSentence(*crashRecord_, options_.program, options_.courseworkFolder,
                       options_.limits.memoryBytes, options_.confinement.get()));
  if (alive)
    fail(WorkerFault::kNonsense,
         "The worker has closed its wire to the host: coursework must not close files that it has "
         "not opened.");
  if (process_.startFailure)
    if (const std::string failure = process_.startFailure(); !failure.empty())
      throw ConfinementError(failure);
  if (end.signal) {
    const WorkerFault fault = faultOfSignal(*end.signal);
    fail(fault, fmt::format("The coursework was ended by {}{}", signalName(*end.signal),
                            fault == WorkerFault::kMemoryLimit ? "; does an array grow without end?"
                                                               : "."));
  }
  if (!greeted_)
    fail(WorkerFault::kEnded,
         fmt::format("The worker could not start and ended with exit code {}: the system allows "
                     "too few open files or too little memory (ulimit -n, ulimit -v), or a global "
                     "variable of the coursework ends it.",
                     end.exitCode));
  fail(WorkerFault::kEnded,
       fmt::format("The worker ended by itself with exit code {}: coursework functions must "
                   "return, and not call exit().",
                   end.exitCode));
}

void WorkerProcess::askWhere(int thread) {
  const pid_t process = pid();
  std::optional<pid_t> number = thread == kMainThread ? process : thread;
  if (thread != kMainThread && process_.inner > 0) number = threadNumber(process, thread);
  if (number) syscall(SYS_tgkill, process, *number, SIGUSR1);
}

// Asks the thread where it is, and ends the worker.
void WorkerProcess::failStalled(int thread) {
  askWhere(thread);
  const auto deadline = Clock::now() + std::chrono::seconds(1);
  while (!crashRecord_ && process_.crash.get() >= 0 && Clock::now() < deadline)
    pump(kPollMilliseconds, 0);
  std::string where;
  if (crashRecord_)
    where = crashPlace(*crashRecord_, options_.program, options_.courseworkFolder,
                       options_.confinement.get());
  if (where.empty()) where = "Somewhere in the coursework";
  fail(WorkerFault::kTimeLimit,
       fmt::format("{}: no answer for {:g} s, stopped; is there a loop that never ends?", where,
                   options_.limits.secondsWithoutAnswer));
}

void WorkerProcess::refuseAnswer(const std::string& sentence) {
  fail(WorkerFault::kNonsense, sentence);
}

void WorkerProcess::fail(WorkerFault fault, const std::string& sentence) {
  closeAll();
  throw WorkerError(fault, sentence);
}

}  // namespace pathmark
