#include "host/adaptive_render.h"

#include "film/replicates.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace pathmark {

namespace {

using Clock = std::chrono::steady_clock;

// A film's means as if every pixel had one ray, so that films with more count no more.
std::vector<FilmPixel> means(std::span<const FilmPixel> film) {
  std::vector<FilmPixel> result(film.begin(), film.end());
  for (FilmPixel& pixel : result)
    if (pixel.rays > 0.0) {
      for (double& sum : pixel.sum) sum /= pixel.rays;
      pixel.rays = 1.0;
    }
  return result;
}

}  // namespace

AdaptiveRender::AdaptiveRender(WorkerProcess& worker, const RenderSettings& settings,
                               double relativeError)
    : worker_(worker),
      settings_(settings),
      target_{relativeError, kPilotRays, mostRays(settings.raysPerPixel) / kFilms},
      shared_(settings.width, settings.height) {
  const std::size_t tiles = tileCount(settings.width, settings.height);
  for (std::uint32_t k = 0; k < kFilms; ++k) {
    films_[k].assign(settings.pixels(), FilmPixel{});
    made_[k].assign(tiles, 0);
    wanted_[k].assign(tiles, kPilotRays);
  }
}

void AdaptiveRender::run(const OnStatus& onStatus) {
  if (!makePilot(onStatus)) return;
  decide();
  complete_ = makeRest(onStatus);
}

bool AdaptiveRender::makePilot(const OnStatus& onStatus) {
  for (std::uint32_t k = 0; k < kFilms; ++k)
    if (!addRays(k, 0, kPilotRays, wanted_[k], onStatus)) return false;
  return true;
}

// Each half by the other's pilot.
void AdaptiveRender::decide() {
  // A number that is cut to the most does not tell whether more was wanted.
  TargetError unlimited = target_;
  unlimited.mostRays = std::uint64_t{1} << 52;
  std::vector<bool> wantsMore(wanted_[0].size());
  for (const std::uint32_t half : {0u, 2u}) {
    const std::uint32_t other = 2 - half;
    std::vector<std::uint64_t> rays = raysForTarget(
        {settings_.width, settings_.height, films_[other], films_[other + 1], kPilotRays},
        unlimited);
    for (std::size_t t = 0; t < rays.size(); ++t) {
      if (rays[t] > target_.mostRays) wantsMore[t] = true;
      rays[t] = std::min(rays[t], target_.mostRays);
    }
    wanted_[half] = wanted_[half + 1] = rays;
  }
  tilesAtMost_ = static_cast<std::size_t>(std::count(wantsMore.begin(), wantsMore.end(), true));
}

// All films and tiles side by side, in steps of about a second, so that an interrupted picture is
// even.
bool AdaptiveRender::makeRest(const OnStatus& onStatus) {
  std::uint64_t most = 0;
  for (const auto& wanted : wanted_)
    most = std::max(most, *std::max_element(wanted.begin(), wanted.end()));
  std::uint64_t passes = 1;
  for (std::uint64_t first = kPilotRays; first < most;) {
    const auto started = Clock::now();
    const std::uint64_t rays = std::min(passes * kPilotRays, most - first);
    for (std::uint32_t k = 0; k < kFilms; ++k)
      if (!addRays(k, first, rays, wanted_[k], onStatus)) return false;
    first += rays;
    const double seconds = std::chrono::duration<double>(Clock::now() - started).count();
    if (seconds < 1.0) passes *= 2;
  }
  return true;
}

// The passes from `firstRay` on, at most `most` rays, of those tiles of which so many are wanted.
// They are added in the order of the passes, whatever the steps: the bits do not depend on these.
bool AdaptiveRender::addRays(std::uint32_t film, std::uint64_t firstRay, std::uint64_t most,
                             const std::vector<std::uint64_t>& wanted, const OnStatus& onStatus) {
  RenderJob job = jobOf(settings_, film);
  job.firstRay = firstRay;
  job.rays = most;
  job.raysByTile = 1;
  job.raysPerPass = kPilotRays;

  double due = 0.0;
  std::vector<std::uint64_t> rays(wanted.size());
  for (std::size_t t = 0; t < wanted.size(); ++t) {
    rays[t] = wanted[t] > firstRay ? std::min(wanted[t] - firstRay, most) : 0;
    due += static_cast<double>(rays[t] * pixelsOfTile(t));
  }
  std::copy(rays.begin(), rays.end(), shared_.tileRays().begin());
  std::copy(films_[film].begin(), films_[film].end(), shared_.pixels().begin());

  const auto started = Clock::now();
  const double total = totalWanted();
  bool going = true;
  const RenderResult made = worker_.render(job, shared_, [&](const RenderProgress& p) {
    const double now = static_cast<double>(p.pixelPassesDone) * kPilotRays;
    const double seconds = std::chrono::duration<double>(Clock::now() - started).count();
    going = onStatus({std::min((raysDone_ + now) / total, 1.0), 0.0, seconds_ + seconds, 0.0,
                      raysTraced_ + p.raysTraced}) &&
            going;
    return going;
  });
  seconds_ += std::chrono::duration<double>(Clock::now() - started).count();
  if (!going) return false;

  const std::vector<FilmPixel> answered(shared_.pixels().begin(), shared_.pixels().end());
  double added = static_cast<double>(made.invalid.count()) * kPilotRays;
  for (std::size_t i = 0; i < answered.size(); ++i) {
    if (!isPossible(answered[i], static_cast<double>(firstRay + most)))
      worker_.refuseAnswer(kScribbled);
    added += answered[i].rays - films_[film][i].rays;
  }
  if (added < due) worker_.refuseAnswer(kScribbled);
  films_[film] = answered;
  for (std::size_t t = 0; t < rays.size(); ++t) made_[film][t] += rays[t];
  invalid_.add(made.invalid);
  raysTraced_ += made.raysTraced;
  raysDone_ += due;
  return true;
}

double AdaptiveRender::totalWanted() const {
  double total = 0.0;
  for (const auto& wanted : wanted_)
    for (std::size_t t = 0; t < wanted.size(); ++t)
      total += static_cast<double>(wanted[t] * pixelsOfTile(t));
  return total;
}

std::uint64_t AdaptiveRender::pixelsOfTile(std::size_t tile) const {
  const auto side = [](int image, std::size_t index) {
    return static_cast<std::uint64_t>(
        std::min(kTileSize, image - static_cast<int>(index) * kTileSize));
  };
  const auto across = static_cast<std::size_t>((settings_.width + kTileSize - 1) / kTileSize);
  return side(settings_.width, tile % across) * side(settings_.height, tile / across);
}

AdaptivePicture AdaptiveRender::picture() const {
  AdaptivePicture result;
  RenderedImage& rendered = result.rendered;
  ReplicateSums sums;
  for (const auto& film : films_) addReplicate(sums, means(film));
  const std::vector<FilmPixel> nothing(settings_.pixels());
  rendered.image = imageFromReplicates(settings_.width, settings_.height, sums, nothing);
  rendered.invalid = invalid_;
  rendered.raysTraced = raysTraced_;
  rendered.seconds = seconds_;
  rendered.complete = complete_;
  rendered.raysPerPixel = raysDone_ / static_cast<double>(settings_.pixels());
  if (!rendered.image.variance.empty()) result.errors = tileErrors(rendered.image);
  result.tilesAtMost = tilesAtMost_;
  const auto tiles = [](int pixels) { return static_cast<std::size_t>(pixels / kTileSize); };
  const std::size_t across = tiles(settings_.width + kTileSize - 1);
  for (int row = 0; row < settings_.height; ++row)
    for (int column = 0; column < settings_.width; ++column) {
      const std::size_t tile = tiles(row) * across + tiles(column);
      std::uint64_t rays = 0;
      for (const auto& made : made_) rays += made[tile];
      result.raysPerPixel.push_back(static_cast<float>(rays));
    }
  return result;
}

}  // namespace pathmark
