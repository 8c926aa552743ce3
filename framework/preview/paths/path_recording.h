// PathRecording: a worker that records, and what it has been given.
#pragma once

#include "host/worker_process.h"
#include "preview/paths/path_engine.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace pathmark::preview {

// Thrown out of a recording that nobody wants any more.
struct Unwanted {};

class PathRecording {
 public:
  PathRecording() = default;
  PathRecording(const PathRecording&) = delete;
  PathRecording& operator=(const PathRecording&) = delete;

  // `wanted` is asked several times a second. Throws Unwanted; what else goes wrong is in the
  // answer.
  PathAnswer record(const PathRequest& request, const std::function<bool()>& wanted);

  // Ends the worker.
  void end();

 private:
  using Clock = std::chrono::steady_clock;

  void start(const PathRequest& request);
  void load(const PathRequest& request);
  void fill(PathAnswer& answer);
  FilmPixel pixelOf(const PathRequest& request, const std::function<void(SharedFilm&)>& render);
  bool isWanted();
  bool isPatient();
  void requireWritten(const PathRequest& request);

  std::unique_ptr<WorkerProcess> worker_;
  std::uint64_t build_ = 0;                    // that the worker is made of
  std::shared_ptr<const PreviewScene> scene_;  // that it has loaded
  const std::function<bool()>* wanted_ = nullptr;
  std::optional<Clock::time_point> unwantedSince_;
};

}  // namespace pathmark::preview
