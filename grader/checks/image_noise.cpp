#include "checks/image_noise.h"

#include "host/reference.h"
#include "host/session.h"
#include "host/shared_memory.h"
#include "sampling/mix.h"
#include "stats/moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

namespace pathmark::checks {

namespace {

constexpr const char* kScene = "cornell_box";
constexpr int kReplicates = 64, kSide = 20;  // pixels of the part that is rendered
constexpr std::uint64_t kRays = 64;          // of a pixel in one replicate, as in the reference

// Of the picture: floor, walls, the shadow of a block.
PixelRegion middleOf(const FlatCamera& camera) {
  const int width = static_cast<int>(camera.width), height = static_cast<int>(camera.height);
  return {width / 2 - kSide / 2, height * 2 / 3 - kSide / 2, kSide, kSide};
}

// The radiance of all three channels of the region's pixels, in their order.
std::vector<double> renderRegion(CheckRun& run, SharedFilm& film, const PixelRegion& region,
                                 int width, std::uint64_t number) {
  RenderJob job;
  job.threads = std::max(1u, std::thread::hardware_concurrency());
  job.seed = mix(run.seed + kGolden * (number + 1));
  job.rays = job.raysPerPass = kRays;
  job.region = region;
  std::fill(film.pixels().begin(), film.pixels().end(), FilmPixel{});
  run.worker.render(job, film, [](const RenderProgress&) { return true; });
  std::vector<double> values;
  for (int j = region.top; j < region.top + region.height; ++j)
    for (int i = region.left; i < region.left + region.width; ++i) {
      const FilmPixel& pixel = film.pixels()[static_cast<std::size_t>(j * width + i)];
      for (const double sum : pixel.sum) values.push_back(sum / static_cast<double>(kRays));
    }
  return values;
}

// The variance of one replicate's pixel, relative to its squared radiance as in relMSE, mean over
// the channels.
class RelativeNoise {
 public:
  void add(double variance, double radiance) {
    pixel_ += variance / (3.0 * (radiance * radiance + 0.01));
    if (++channels_ % 3 != 0) return;
    pixels_.add(pixel_);
    pixel_ = 0.0;
  }
  double mean() const { return pixels_.mean(); }
  double relativeError() const { return pixels_.standardError() / pixels_.mean(); }

 private:
  stats::RunningMoments pixels_;
  double pixel_ = 0.0;
  int channels_ = 0;
};

// Whether the region is as bright as the reference's: of a wrong picture the noise says nothing.
class Brightness {
 public:
  void add(const stats::RunningMoments& mine, double theirs, double theirVariance) {
    mine_ += mine.mean();
    theirs_ += theirs;
    variance_ += mine.standardError() * mine.standardError() + theirVariance;
  }
  bool isThatOfTheReference() const {
    constexpr double kSame = 0.02, kSigmas = 5.0;
    return std::abs(mine_ - theirs_) <= kSame * theirs_ + kSigmas * std::sqrt(variance_);
  }

 private:
  double mine_ = 0.0, theirs_ = 0.0, variance_ = 0.0;
};

std::string remarkOn(double ratio, double error) {
  // Within this nobody would see a difference.
  constexpr double kAlike = 1.25, kSigmas = 3.0;
  if (ratio - kSigmas * error > kAlike)
    return fmt::format(
        "correct, but noisier than it could be: with the same number of rays {} has {:.1f} +- "
        "{:.1f} times the variance of the reference, as if only {:.0f} % of the rays were traced",
        kScene, ratio, error, 100.0 / ratio);
  if (ratio + kSigmas * error < 1.0 / kAlike)
    return fmt::format("less noise than the reference: {:.2f} +- {:.2f} times its variance", ratio,
                       error);
  return {};
}

}  // namespace

Finding noiseIsThatOfTheReference(CheckRun& run) {
  const LoadedScene scene = loadScene(shippedSceneFile(kScene));
  const std::optional<ImageFile> reference = readReference(scene);
  Finding finding;
  const bool comparable =
      reference && !reference->image.variance.empty() && reference->origin.replicates > 1 &&
      reference->origin.raysPerPixel == static_cast<double>(kRays * reference->origin.replicates);
  if (!comparable) {
    finding.status = Status::kBlocked;
    finding.cause = fmt::format(
        "a reference image that is missing or has no variance: ./pathmark reference {}", kScene);
    return finding;
  }
  const PixelRegion region = middleOf(scene.flat.camera);
  const int width = static_cast<int>(scene.flat.camera.width),
            height = static_cast<int>(scene.flat.camera.height);
  run.worker.loadScene(scene.flat);
  SharedFilm film(width, height);
  std::vector<stats::RunningMoments> moments(3 * kSide * kSide);
  for (std::uint64_t r = 0; r < kReplicates; ++r) {
    const std::vector<double> values = renderRegion(run, film, region, width, r);
    for (std::size_t k = 0; k < values.size(); ++k) moments[k].add(values[k]);
  }
  RelativeNoise mine, theirs;
  Brightness brightness;
  std::size_t k = 0;
  for (int j = region.top; j < region.top + region.height; ++j)
    for (int i = region.left; i < region.left + region.width; ++i)
      for (std::size_t c = 0; c < 3; ++c, ++k) {
        const auto at = static_cast<std::size_t>(3 * (j * width + i)) + c;
        const double radiance = reference->image.rgb[at];
        const double variance = reference->image.variance[at];
        mine.add(moments[k].variance(), radiance);
        theirs.add(variance * reference->origin.replicates, radiance);
        brightness.add(moments[k], radiance, variance);
      }
  finding.calls = kReplicates * kRays * kSide * kSide;
  const double ratio = mine.mean() / theirs.mean();
  const double error = ratio * std::hypot(mine.relativeError(), theirs.relativeError());
  finding.got = fmt::format("variance / that of the reference = {:.2f} +- {:.2f}", ratio, error);
  if (brightness.isThatOfTheReference()) finding.remark = remarkOn(ratio, error);
  return finding;
}

}  // namespace pathmark::checks
