// WorkerProcess: a worker as the host sees it, answers and all, none of them trusted.
//
//   start              a new worker, ready for requests
//   stubs              functions that are still marked as unwritten
//   loadScene          hands a scene over
//   render             adds rays to a film
//   call               calls a coursework function on given inputs
//   estimate           means of an estimator over many rays
//   recordPixel        what renderPixel does, ray by ray
//   recordPaths        adds rays to a film, and says what happens on them
//
// Everything a worker can do wrong (crash, fall silent, print without end, end by itself, answer
// nonsense) ends it and is thrown as a WorkerError whose text is a sentence for a student.
#pragma once

#include "host/confinement.h"
#include "host/recorded_paths.h"
#include "host/shared_memory.h"
#include "render/render_job.h"
#include "render/skips.h"
#include "scene/flat_scene.h"
#include "worker/contract.h"
#include "worker/protocol.h"

#include <pathmark/unimplemented.h>

#include <chrono>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/types.h>

namespace pathmark {

enum class WorkerFault {
  kCrashed,
  kTimeLimit,
  kOutputLimit,
  kEnded,     // by itself: exit() in coursework
  kNonsense,  // an answer that does not fit the question
  kMemoryLimit,
  kForbiddenCall,  // of the operating system, from within a sandbox
};

class WorkerError : public std::runtime_error {
 public:
  WorkerError(WorkerFault fault, const std::string& sentence)
      : std::runtime_error(sentence), fault_(fault) {}
  WorkerFault fault() const { return fault_; }

 private:
  WorkerFault fault_;
};

// Thrown where Options::goOn said no. It is no WorkerError: it says nothing of the coursework.
class WorkerStopped : public std::exception {
 public:
  const char* what() const noexcept override { return "the worker was stopped"; }
};

struct WorkerLimits {
  double secondsWithoutAnswer = 10.0;  // of a call, or of a render thread within one pixel's pass
  std::size_t outputBytes = std::size_t{1} << 20;  // that coursework may print
  std::size_t memoryBytes = memoryForWorker();     // of address space
};

struct RecordedPixel {
  RecordPixelReply counts;
  std::vector<RecordedRay> rays;
};

struct RenderProgress {
  std::uint64_t pixelPassesDone = 0;
  std::uint64_t raysTraced = 0;
};

class WorkerProcess {
 public:
  struct Options {
    std::filesystem::path program;
    std::filesystem::path courseworkFolder;  // for naming files in messages
    WorkerLimits limits;
    std::shared_ptr<Confinement> confinement;      // often none
    std::function<void(std::string_view)> onText;  // what the coursework prints

    // Asked several times a second while an answer is waited for; if it says no, the worker is
    // ended, and WorkerStopped thrown.
    std::function<bool()> goOn;
  };

  // Throws WorkerError; std::system_error or ConfinementError if the machine cannot start a
  // process.
  explicit WorkerProcess(Options options);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  std::vector<StubRecord> stubs();
  void loadScene(const FlatScene& scene, Skips skips = {});

  // `onProgress` is called several times a second and returns whether to go on; if it does not,
  // the film holds what was rendered until then.
  RenderResult render(const RenderJob& job, SharedFilm& film,
                      const std::function<bool(const RenderProgress&)>& onProgress);

  // As render, of a job for one thread. Needs a worker of linkForRecording.
  RecordedPaths recordPaths(const RenderJob& job, SharedFilm& film,
                            const std::function<bool(const RenderProgress&)>& onProgress);

  // Words as described in contract.h; `inputs` holds any number of calls.
  std::vector<std::uint32_t> call(CourseworkFunction function,
                                  std::span<const std::uint32_t> object,
                                  std::span<const std::uint32_t> inputs);

  // Means of directLighting or tracePath; `inputs` holds request.calls calls, as protocol.h says.
  // Needs a scene.
  std::vector<Estimate> estimate(const EstimateRequest& request,
                                 std::span<const std::uint32_t> inputs);

  // Needs a scene, and a worker in which tracePath is the stand-in that records.
  RecordedPixel recordPixel(const RecordPixelRequest& request);

  // Ends the worker for an answer that a closer look has shown to be none, and throws.
  [[noreturn]] void refuseAnswer(const std::string& sentence);

  // Of the worker itself, whatever process stands in front of it.
  pid_t pid() const { return process_.inner > 0 ? process_.inner : process_.pid; }

 private:
  using Clock = std::chrono::steady_clock;
  class StallWatch;
  static constexpr int kMainThread = 0;

  std::uint32_t sendRequest(MessageKind kind, std::span<const std::byte> body, int descriptor);
  void sendBytes(std::span<const std::byte> bytes, int descriptor);
  std::vector<std::byte> awaitReply(MessageKind kind, std::uint32_t sequence,
                                    std::uint64_t smallest, std::uint64_t largest,
                                    const std::function<std::optional<int>()>& stalledThread);
  std::vector<std::byte> renderInto(MessageKind kind, const RenderJob& job, SharedFilm& film,
                                    std::uint64_t smallest, std::uint64_t largest,
                                    const std::function<bool(const RenderProgress&)>& onProgress);
  std::optional<int> silentFor(Clock::time_point since) const;
  void stopIfAsked();
  bool pump(int timeoutMilliseconds, short socketEvents);
  void readText();
  bool readCrash();
  [[noreturn]] void failDead();
  [[noreturn]] void failStalled(int thread);
  [[noreturn]] void fail(WorkerFault fault, const std::string& sentence);
  void askWhere(int thread);
  int reap();
  void closeAll();

  Options options_;
  LaunchedWorker process_;
  bool greeted_ = false;  // it has said that it is ready
  std::uint32_t nextSequence_ = 1;
  std::size_t textBytes_ = 0;
  std::optional<CrashRecord> crashRecord_;
  SealedBlock sceneBlock_;
};

}  // namespace pathmark
