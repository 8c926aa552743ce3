// AdaptiveRender: a picture of which every tile gets as many rays as a stated error needs.
//
// Four films with random numbers of their own make the picture: two for each of the halves of
// adaptive_rule.h. All get a pilot; then those of each half go on to what the other's pilot asks
// for.
#pragma once

#include "host/adaptive_rule.h"
#include "host/render_loop.h"

#include <array>
#include <functional>
#include <vector>

namespace pathmark {

struct AdaptivePicture {
  RenderedImage rendered;           // with variances
  std::vector<float> raysPerPixel;  // of each pixel, all films together
  TileErrors errors;                // empty if a pixel has no variance yet
  std::size_t tilesAtMost = 0;      // that would have needed more rays than are allowed
};

class AdaptiveRender {
 public:
  static constexpr std::uint32_t kFilms = 4;
  static constexpr std::uint32_t kPilotRays = 16;  // of each pixel in each film: one pass

  // What can be made of so many rays of a pixel: whole passes, in which points are spread evenly,
  // and the same in each film.
  static constexpr std::uint64_t mostRays(std::uint64_t allowed) {
    constexpr std::uint64_t kStep = std::uint64_t{kFilms} * kPilotRays;
    return allowed / kStep * kStep;
  }

  // `settings` says the size, the most rays of a pixel, at least kFilms * kPilotRays, the seed, the
  // sampler and the threads; it must ask for no replicates. The worker must outlive this object.
  AdaptiveRender(WorkerProcess& worker, const RenderSettings& settings, double relativeError);

  // Until it is done or `onStatus` ends it. Throws WorkerError.
  void run(const OnStatus& onStatus);

  AdaptivePicture picture() const;

 private:
  bool addRays(std::uint32_t film, std::uint64_t firstRay, std::uint64_t most,
               const std::vector<std::uint64_t>& wanted, const OnStatus& onStatus);
  bool makePilot(const OnStatus& onStatus);
  bool makeRest(const OnStatus& onStatus);
  void decide();
  double totalWanted() const;
  std::uint64_t pixelsOfTile(std::size_t tile) const;

  WorkerProcess& worker_;
  RenderSettings settings_;
  TargetError target_;
  SharedFilm shared_;
  std::array<std::vector<FilmPixel>, kFilms> films_;
  std::array<std::vector<std::uint64_t>, kFilms> made_;    // rays of a pixel, by tile
  std::array<std::vector<std::uint64_t>, kFilms> wanted_;  // the same
  std::size_t tilesAtMost_ = 0;
  InvalidPixels invalid_;
  std::uint64_t raysTraced_ = 0;
  double seconds_ = 0.0, raysDone_ = 0.0;
  bool complete_ = false;
};

}  // namespace pathmark
