#include "render/split_paths.h"

#include "render/first_surface.h"

#include <algorithm>

namespace pathmark {

namespace {

// Keeps the paths' numbers apart from the camera rays', which are made of the same seeds.
constexpr std::uint64_t kStream = 0x73706c6974747468ull;

}  // namespace

SplitPaths::SplitPaths(const SceneCore& core, const RenderJob& job)
    : scene_(core, core.maxBounces()),
      direct_(core, std::min(core.maxBounces(), 1)),
      sharesDirectLight_(job.sharing.directLight != 0),
      pathsPerRay_(static_cast<int>(job.sharing.pathsPerRay)),
      sampler_(makePixelSampler(job.sampler, mix(job.seed ^ kStream),
                                job.raysPerPass * job.sharing.pathsPerRay)) {}

void SplitPaths::startPixel(int i, int j, std::uint64_t raysBefore) {
  sampler_->startPixel(i, j, raysBefore * static_cast<std::uint64_t>(pathsPerRay_));
}

Colour SplitPaths::radiance(const Ray& cameraRay, int m, Sampler& sampler) {
  Hit surface;
  if (!scene_.intersect(cameraRay, surface)) return Colour(0.0f);
  Colour shared(0.0f);
  if (sharesDirectLight_) {
    beginWithSurface(surface, false);
    shared = direct_.tracePath(cameraRay, sampler);
    if (scene_.maxBounces() <= 1) {
      beginAnywhere();
      return shared;
    }
  }
  Colour sum(0.0f);
  for (int k = 0; k < pathsPerRay_; ++k) {
    sampler_->startPath(m * pathsPerRay_ + k);
    beginWithSurface(surface, sharesDirectLight_);
    sum += scene_.tracePath(cameraRay, *sampler_);
  }
  beginAnywhere();
  return shared + sum / static_cast<float>(pathsPerRay_);
}

}  // namespace pathmark
