// Where a value that is no radiance comes from.
//
//   firstInvalid    the first function, on recorded paths, that returned one or passed one on
//   invalidOrigin   the same of a rendered pixel, whose rays are made again for that
#pragma once

#include "host/render_state.h"
#include "host/session.h"
#include "worker/path_events.h"

#include <cstdint>
#include <span>
#include <string>

namespace pathmark {

// A sentence; empty if no path has returned such a value, or nobody knows.
std::string firstInvalid(std::span<const PathEvent> paths, const FlatScene& scene,
                         Estimator estimator);

// How the rays of each pixel were made.
struct PixelPasses {
  std::uint32_t replicates = 1;  // with seeds of their own
  std::uint64_t rays = 64;       // in each of them
  std::uint32_t raysPerPass = 64;
};

// Of a picture by the coursework's renderPixel or tracePathMIS, in which the pixel has such a
// value; empty of others, and where it takes longer than a few seconds. Throws nothing: a picture
// is there already.
std::string invalidOrigin(const Coursework& coursework, const LoadedScene& scene,
                          const RenderSettings& settings, const PixelPasses& passes,
                          std::uint64_t pixel);

}  // namespace pathmark
