// What a render asks of a worker, and what comes back; shared by the host and the worker.
//
//   FilmPixel       sums in double of what renderPixel returned
//   RenderJob       which rays to make, in which part of the image
//   InvalidPixels   values that are no radiance, counted and kept out of the film
#pragma once

#include "render/path_automaton.h"
#include "sampling/sampler_kind.h"
#include "scene/flat_scene.h"

#include <algorithm>
#include <cstdint>

namespace pathmark {

struct FilmPixel {
  double sum[3] = {0.0, 0.0, 0.0};  // radiance times rays
  double rays = 0.0;                // rays in the sum
};

// Pixels on a side of what one thread renders at a time.
inline constexpr int kTileSize = 16;

// Tiles of an image, row by row from the top left.
constexpr std::size_t tileCount(int width, int height) {
  const auto across = [](int pixels) {
    return static_cast<std::size_t>((pixels + kTileSize - 1) / kTileSize);
  };
  return across(width) * across(height);
}

enum class Estimator : std::uint32_t {
  kPath = 0,    // renderPixel, and so tracePath
  kWarmUp = 1,  // part 0
  kMis = 2,     // part 8's tracePathMIS
  kSplit = 3,   // several paths of tracePath from each camera ray
  kReuse = 4,   // paths of tracePath that serve all pixels of a block
};

// What paths have in common.
struct PathSharing {
  static constexpr std::uint32_t kMost = 64;  // of each

  // Of Estimator::kSplit: paths that share a camera ray; and 1: its direct light, too.
  std::uint32_t pathsPerRay = 1, directLight = 0;

  // Of Estimator::kReuse: pixels of a block whose paths serve all of them, a power of two; and
  // paths for the direct light of each camera ray.
  std::uint32_t pixels = 1, directPaths = 1;
};

// Pixels of the image, from the top left.
struct PixelRegion {
  std::int32_t left = 0, top = 0;
  std::int32_t width = 0, height = 0;
};

struct RenderJob {
  Estimator estimator = Estimator::kPath;
  SamplerKind sampler = SamplerKind::kSobol;
  std::uint32_t threads = 1;
  std::uint64_t seed = 0;
  std::uint64_t firstRay = 0;    // of each pixel: a multiple of raysPerPass
  std::uint64_t rays = 1;        // of each pixel, in this job
  std::uint32_t raysByTile = 0;  // 1: so many of each pixel as its tile has in the film's memory,
                                 // at most `rays`; the region then begins at a tile
  std::uint32_t raysPerPass = 1;
  PathSharing sharing;
  PixelRegion region;           // to render; what reaches beyond the image is cut off
  std::uint32_t ownCamera = 0;  // 1: the camera is `camera` and not the scene's
  FlatCamera camera;
  PathAutomaton paths;  // that light is let through along; not of the warm-up
};

struct InvalidPixels {
  static constexpr std::uint64_t kNone = ~std::uint64_t{0};

  std::uint64_t nan = 0, infinite = 0, negative = 0;  // passes of pixels
  std::uint64_t firstPixel = kNone;                   // lowest row * width + column

  std::uint64_t count() const { return nan + infinite + negative; }

  void add(const InvalidPixels& other) {
    nan += other.nan;
    infinite += other.infinite;
    negative += other.negative;
    firstPixel = std::min(firstPixel, other.firstPixel);
  }
};

struct RenderResult {
  std::uint64_t raysTraced = 0;  // camera, bounce and shadow rays
  InvalidPixels invalid;
};

}  // namespace pathmark
