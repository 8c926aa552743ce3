// What bench error compares renders with.
//
//   BenchReference   an image and its own error
//   referenceFor     a shipped one, or one made for a scene whose size or bounces were changed
#pragma once

#include "bench/image_error.h"
#include "host/session.h"

#include <string>

namespace pathmark::bench {

struct BenchReference {
  Image image;
  std::uint32_t replicates = 1;
  OwnDeviation own;
};

// From `file` if one is named; else the shipped one, if it fits the scene; else one made with the
// coursework, by its part 8 where that is written, which is kept in the build folder. Throws
// UsageError, ImageError, WorkerError, and Interrupted.
BenchReference referenceFor(const LoadedScene& scene, const Coursework& coursework,
                            std::uint64_t raysPerPixel, const std::string& file);

}  // namespace pathmark::bench
