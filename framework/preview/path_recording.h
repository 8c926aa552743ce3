// PathRecording: a worker that records, and what it has been given.
#pragma once

#include "host/worker_process.h"
#include "preview/path_engine.h"

#include <functional>
#include <memory>

namespace pathmark::preview {

// Thrown out of a recording that nobody wants any more.
struct Unwanted {
  bool workerIsReady = false;  // for the next one
};

class PathRecording {
 public:
  // `wanted` is asked several times a second. Throws Unwanted; what else goes wrong is in the
  // answer.
  PathAnswer record(const PathRequest& request, const std::function<bool()>& wanted);

 private:
  void start(const PathRequest& request);
  void load(const PathRequest& request);
  template <class Render>
  FilmPixel pixelOf(const PathRequest& request, const Render& render);
  void fill(PathAnswer& answer, const std::function<bool()>& wanted);

  std::unique_ptr<WorkerProcess> worker_;
  std::uint64_t build_ = 0;                    // that the worker is made of
  std::shared_ptr<const PreviewScene> scene_;  // that it has loaded
  FlatCamera camera_;
};

}  // namespace pathmark::preview
