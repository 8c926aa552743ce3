// What a worker is asked for, and what its answers must be like to be believed.
#include "host/message_bytes.h"
#include "host/worker_process.h"

#include <fmt/format.h>

#include <stdexcept>

namespace pathmark {

namespace {

void append(std::vector<std::byte>& body, std::span<const std::byte> bytes) {
  body.insert(body.end(), bytes.begin(), bytes.end());
}

}  // namespace

// A thread that stays within one pixel's pass for too long, by its own words on the board.
class WorkerProcess::StallWatch {
 public:
  StallWatch(const ProgressBoard& board, std::uint32_t threads, double limitSeconds)
      : board_(board), seen_(threads), limit_(limitSeconds) {}

  std::optional<int> stalledThread() {
    const auto now = Clock::now();
    for (std::size_t k = 0; k < seen_.size(); ++k) {
      const ThreadSlot& slot = board_.threads[k];
      const std::uint64_t done = slot.pixelsDone.load(std::memory_order_relaxed);
      const int id = slot.threadId.load(std::memory_order_relaxed);
      if (id == 0 || done != seen_[k].done || seen_[k].since == Clock::time_point{})
        seen_[k] = {done, now};
      else if (std::chrono::duration<double>(now - seen_[k].since).count() > limit_)
        return id;
    }
    return std::nullopt;
  }

 private:
  struct Seen {
    std::uint64_t done = 0;
    Clock::time_point since{};
  };
  const ProgressBoard& board_;
  std::vector<Seen> seen_;
  double limit_;
};

std::vector<StubRecord> WorkerProcess::stubs() {
  constexpr std::size_t kMost = 1000;
  const auto started = Clock::now();
  const std::uint32_t sequence = sendRequest(MessageKind::kStubs, {}, -1);
  const auto body = awaitReply(MessageKind::kStubs, sequence, 0, kMost * sizeof(StubRecord),
                               [&] { return silentFor(started); });
  if (body.size() % sizeof(StubRecord) != 0)
    fail(WorkerFault::kNonsense, "The worker's list of unwritten functions makes no sense.");
  std::vector<StubRecord> records(body.size() / sizeof(StubRecord));
  if (!records.empty()) std::memcpy(records.data(), body.data(), body.size());
  for (StubRecord& r : records) r.file[sizeof r.file - 1] = r.function[sizeof r.function - 1] = 0;
  return records;
}

void WorkerProcess::loadScene(const FlatScene& scene, Skips skips) {
  sceneBlock_ = SealedBlock([&](const TakeBytes& take) { packScene(scene, take); });
  const auto started = Clock::now();
  const LoadSceneRequest request{sceneBlock_.bytes(), skips.bits()};
  const std::uint32_t sequence =
      sendRequest(MessageKind::kLoadScene, bytesOf(request), sceneBlock_.descriptor());
  const auto body = awaitReply(MessageKind::kLoadScene, sequence, sizeof(LoadSceneReply),
                               sizeof(LoadSceneReply), [&] { return silentFor(started); });
  if (valueOf<LoadSceneReply>(body).understood != 1)
    fail(WorkerFault::kNonsense, "The worker did not understand the scene.");
}

std::vector<std::byte> WorkerProcess::renderInto(
    MessageKind kind, const RenderJob& job, SharedFilm& film, std::uint64_t smallest,
    std::uint64_t largest, const std::function<bool(const RenderProgress&)>& onProgress) {
  ProgressBoard& board = film.board();
  board.cancel = 0;
  for (ThreadSlot& slot : board.threads) {
    slot.pixelsDone = 0;
    slot.raysTraced = 0;
    slot.threadId = 0;
  }
  StallWatch watch(board, job.threads, options_.limits.secondsWithoutAnswer);
  auto lastSign = Clock::now();
  const auto watchAndTell = [&]() -> std::optional<int> {
    RenderProgress progress;
    bool working = false;
    for (std::uint32_t k = 0; k < job.threads; ++k) {
      progress.pixelPassesDone += board.threads[k].pixelsDone;
      progress.raysTraced += board.threads[k].raysTraced;
      working = working || board.threads[k].threadId != 0;
    }
    if (!onProgress(progress)) board.cancel = 1;
    // With no thread at work the reply itself is due.
    if (working) lastSign = Clock::now();
    if (const auto thread = watch.stalledThread()) return thread;
    return silentFor(lastSign);
  };
  const RenderRequest request{job, film.bytes()};
  const std::uint32_t sequence = sendRequest(kind, bytesOf(request), film.descriptor());
  return awaitReply(kind, sequence, smallest, largest, watchAndTell);
}

RenderResult WorkerProcess::render(const RenderJob& job, SharedFilm& film,
                                   const std::function<bool(const RenderProgress&)>& onProgress) {
  return valueOf<RenderResult>(renderInto(MessageKind::kRender, job, film, sizeof(RenderResult),
                                          sizeof(RenderResult), onProgress));
}

RecordedPaths WorkerProcess::recordPaths(
    const RenderJob& job, SharedFilm& film,
    const std::function<bool(const RenderProgress&)>& onProgress) {
  const auto reply =
      renderInto(MessageKind::kRecordPaths, job, film, 0,
                 sizeof(RecordPathsReply) + kMostPathEvents * sizeof(PathEvent), onProgress);
  const auto paths = readRecordedPaths(reply);
  if (!paths) fail(WorkerFault::kNonsense, "The worker's record of the paths makes no sense.");
  return *paths;
}

std::vector<std::uint32_t> WorkerProcess::call(CourseworkFunction function,
                                               std::span<const std::uint32_t> object,
                                               std::span<const std::uint32_t> inputs) {
  const FunctionContract& contract = contractOf(function);
  if (inputs.size() % contract.inputWords != 0)
    throw std::invalid_argument(
        fmt::format("{} takes {} words a call", contract.name, contract.inputWords));
  const std::uint64_t count = inputs.size() / contract.inputWords;
  std::vector<std::byte> body;
  append(body, bytesOf(CallRequest{static_cast<std::uint32_t>(function),
                                   static_cast<std::uint32_t>(object.size()), count}));
  append(body, std::as_bytes(object));
  append(body, std::as_bytes(inputs));

  const auto started = Clock::now();
  const std::uint64_t bytes = count * contract.outputWords * sizeof(std::uint32_t);
  const std::uint32_t sequence = sendRequest(MessageKind::kCall, body, -1);
  const auto reply =
      awaitReply(MessageKind::kCall, sequence, 0, bytes, [&] { return silentFor(started); });
  if (reply.size() != bytes)
    fail(WorkerFault::kNonsense,
         fmt::format("The worker could not call {}: its answer has {} bytes where {} belong.",
                     contract.name, reply.size(), bytes));
  std::vector<std::uint32_t> words(reply.size() / sizeof(std::uint32_t));
  if (!words.empty()) std::memcpy(words.data(), reply.data(), reply.size());
  return words;
}

std::vector<Estimate> WorkerProcess::estimate(const EstimateRequest& request,
                                              std::span<const std::uint32_t> inputs) {
  std::vector<std::byte> body;
  append(body, bytesOf(request));
  append(body, std::as_bytes(inputs));
  const auto started = Clock::now();
  const std::uint64_t bytes = std::uint64_t{request.calls} * request.replicates * sizeof(Estimate);
  const std::uint32_t sequence = sendRequest(MessageKind::kEstimate, body, -1);
  const auto reply =
      awaitReply(MessageKind::kEstimate, sequence, 0, bytes, [&] { return silentFor(started); });
  if (reply.size() != bytes)
    fail(WorkerFault::kNonsense, "The worker's estimates do not fit what was asked.");
  std::vector<Estimate> estimates(reply.size() / sizeof(Estimate));
  if (!estimates.empty()) std::memcpy(estimates.data(), reply.data(), reply.size());
  return estimates;
}

RecordedPixel WorkerProcess::recordPixel(const RecordPixelRequest& request) {
  const auto started = Clock::now();
  const std::uint64_t most =
      sizeof(RecordPixelReply) +
      (static_cast<std::uint64_t>(request.rays) + kExtraRecordedRays) * sizeof(RecordedRay);
  const std::uint32_t sequence = sendRequest(MessageKind::kRecordPixel, bytesOf(request), -1);
  const auto reply = awaitReply(MessageKind::kRecordPixel, sequence, sizeof(RecordPixelReply), most,
                                [&] { return silentFor(started); });
  if ((reply.size() - sizeof(RecordPixelReply)) % sizeof(RecordedRay) != 0)
    fail(WorkerFault::kNonsense, "The worker's record of a pixel makes no sense.");
  RecordedPixel pixel{valueOf<RecordPixelReply>(reply), {}};
  pixel.rays.resize((reply.size() - sizeof(RecordPixelReply)) / sizeof(RecordedRay));
  if (!pixel.rays.empty())
    std::memcpy(pixel.rays.data(), reply.data() + sizeof(RecordPixelReply),
                pixel.rays.size() * sizeof(RecordedRay));
  return pixel;
}

}  // namespace pathmark
