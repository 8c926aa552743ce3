// SampleEngine: draws samples on a thread of its own, with a worker of its own.
//
//   SampleAnswer   samples, or a sentence about why there are none; immutable
//   SampleEngine   shows the newest answer to the newest request
//
// The worker holds the part of the function that is asked for, and stand-ins for the others.
#pragma once

#include "host/worker_process.h"
#include "preview/picture.h"
#include "preview/samples/sample_set.h"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace pathmark::preview {

struct SampleAnswer {
  enum class Kind { kSamples, kNotWritten, kTrouble };

  std::uint64_t build = 0;  // CourseworkState::number that it is about
  SampleSettings settings;
  Kind kind = Kind::kTrouble;
  std::string sentence;  // why there are no samples
  std::string note;      // what to know about them
  SampleSet set;
};

class SampleEngine {
 public:
  // `wake` is called when there is a new answer, from any thread.
  explicit SampleEngine(std::function<void()> wake,
                        const WorkerLimits& limits = {.secondsWithoutAnswer = 3.0});
  ~SampleEngine();
  SampleEngine(const SampleEngine&) = delete;
  SampleEngine& operator=(const SampleEngine&) = delete;

  // Returns at once. Only the newest request counts; nothing is done for one that is as the one
  // before. The coursework must have been built.
  void show(const std::shared_ptr<const CourseworkState>& coursework,
            const SampleSettings& settings);

  std::shared_ptr<const SampleAnswer> newest() const;  // null before the first

 private:
  struct Request {
    std::shared_ptr<const CourseworkState> coursework;
    SampleSettings settings;
    std::stop_token stop;  // when another build has come
  };
  struct Session;

  void run(const std::stop_token& stop);
  std::optional<SampleAnswer> answerTo(const Request& request, Session& session) const;
  void start(const Request& request, Session& session) const;

  const std::function<void()> wake_;
  const WorkerLimits limits_;

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<Request> waiting_;
  std::uint64_t lastBuild_ = 0;
  std::optional<SampleSettings> lastSettings_;
  std::stop_source otherBuild_;
  std::shared_ptr<const SampleAnswer> newest_;

  std::jthread thread_;
};

}  // namespace pathmark::preview
