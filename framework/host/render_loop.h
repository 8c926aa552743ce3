// renderImage: makes the passes of an image with a worker, in the same order as the preview.
#pragma once

#include "film/image.h"
#include "host/worker_process.h"

#include <cstdint>
#include <functional>

namespace pathmark {

struct RenderSettings {
  int width = 1, height = 1;
  std::uint64_t raysPerPixel = 64;
  std::uint32_t threads = 1;
  std::uint64_t seed = 0;
  Estimator estimator = Estimator::kPath;
};

struct RenderStatus {
  double fraction = 0.0;  // of the image's rays, [0,1]
  double seconds = 0.0;
  std::uint64_t raysTraced = 0;
};

struct RenderedImage {
  Image image;
  InvalidPixels invalid;
  std::uint64_t raysTraced = 0;
  double raysPerPixel = 0.0;  // made; fewer than asked for if it was interrupted
  double seconds = 0.0;
  bool complete = true;
};

// Rays of one renderPixel call: the smaller of N and 64.
std::uint32_t raysPerPass(std::uint64_t raysPerPixel);

// `onStatus` is called several times a second and returns whether to go on. Throws WorkerError.
RenderedImage renderImage(WorkerProcess& worker, const RenderSettings& settings,
                          const std::function<bool(const RenderStatus&)>& onStatus);

}  // namespace pathmark
