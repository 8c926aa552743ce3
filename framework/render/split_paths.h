// SplitPaths: several paths of one camera ray, which share the surface that it meets first.
//
// Most of the noise is from what happens after that surface: then a camera ray is better shared by
// several paths (splitting: Arvo & Kirk, "Particle Transport and Image Synthesis", SIGGRAPH 1990,
// section 4). Each is the coursework's tracePath with numbers of its own, and the mean over them
// is what one path gives in the mean. Where direct light is less noisy than the rest, they can
// share that as well: what the first surface emits and its direct light are those of a path of one
// bounce, and the other paths do not see them.
#pragma once

#include "render/render_job.h"
#include "render/scene_core.h"
#include "sampling/pixel_sampler.h"

#include <memory>

namespace pathmark {

class SplitPaths {
 public:
  // The core must outlive it.
  SplitPaths(const SceneCore& core, const RenderJob& job);

  // The next camera rays belong to pixel (i, j), of which earlier passes have made `raysBefore`.
  void startPixel(int i, int j, std::uint64_t raysBefore);

  // The radiance that comes along the m-th camera ray since then; `sampler` has the numbers of that
  // ray, the paths have their own.
  Colour radiance(const Ray& cameraRay, int m, Sampler& sampler);

 private:
  LitScene scene_, direct_;  // with all bounces, and with one at most
  bool sharesDirectLight_;
  int pathsPerRay_;
  std::unique_ptr<PixelSampler> sampler_;  // of the paths: as of so many times the rays
};

}  // namespace pathmark
