#include "host/render_state.h"

#include "sampling/mix.h"

#include <algorithm>
#include <limits>

namespace pathmark {

namespace {

// Rays of each pixel in the pass that begins at firstRay.
std::uint64_t raysOfPass(const RenderSettings& settings, std::uint64_t firstRay) {
  return std::min<std::uint64_t>(settings.raysPerPass(), settings.raysPerReplicate() - firstRay);
}

}  // namespace

std::uint32_t RenderSettings::raysPerPass() const {
  return pathmark::raysPerPass(raysPerReplicate());
}

std::uint64_t RenderSettings::pixels() const {
  return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
}

std::uint32_t raysPerPass(std::uint64_t raysPerPixel) {
  constexpr std::uint64_t kLargestPass = 64;
  return static_cast<std::uint32_t>(std::min(raysPerPixel, kLargestPass));
}

bool isPossible(const FilmPixel& pixel, double mostRays) {
  constexpr double kRounding = 1.0 + 1e-6;
  constexpr double kMostRadiance = kRounding * std::numeric_limits<float>::max();
  // Written so that NaN fails.
  const auto within = [](double x, double most) { return x >= 0.0 && x <= most; };
  const double most = kMostRadiance * pixel.rays;
  return within(pixel.rays, mostRays) && within(pixel.sum[0], most) && within(pixel.sum[1], most) &&
         within(pixel.sum[2], most);
}

std::uint64_t replicateSeed(std::uint64_t seed, std::uint64_t replicate) {
  return replicate == 0 ? seed : mix(mix(seed + kGolden) + replicate * kGolden);
}

std::uint64_t raysMade(const RenderSettings& settings, const RenderState& state) {
  const std::uint64_t whole = state.replicate * settings.raysPerReplicate() + state.firstRay;
  const std::uint64_t above = state.row * static_cast<std::uint64_t>(settings.width);
  return whole * settings.pixels() + above * raysOfPass(settings, state.firstRay);
}

bool finished(const RenderSettings& settings, const RenderState& state) {
  return state.replicate * settings.raysPerReplicate() + state.firstRay >= settings.raysPerPixel;
}

RenderJob jobOf(const RenderSettings& settings, std::uint64_t replicate) {
  RenderJob job;
  job.estimator = settings.estimator;
  job.sharing = settings.sharing;
  job.sampler = settings.sampler;
  job.paths = settings.automaton;
  job.threads = settings.threads;
  job.seed = replicateSeed(settings.seed, replicate);
  job.raysPerPass = settings.raysPerPass();
  job.region = {0, 0, settings.width, settings.height};
  if (settings.camera) {
    job.ownCamera = 1;
    job.camera = *settings.camera;
  }
  return job;
}

// All pixels get their rays of one job before any gets those of the next, so that an interrupted
// image is even.
RenderJob nextJob(const RenderSettings& settings, const RenderState& state, double pixelPasses) {
  RenderJob job = jobOf(settings, state.replicate);
  job.firstRay = state.firstRay;
  const double passes = pixelPasses / static_cast<double>(settings.pixels());
  if (state.row == 0 && passes >= 1.0) {
    const std::uint64_t left = settings.raysPerReplicate() - state.firstRay;
    const double rays = std::min(passes, static_cast<double>(left));  // no pass has less than one
    job.rays = std::min(static_cast<std::uint64_t>(rays) * job.raysPerPass, left);
    return job;
  }
  // Whole rows of tiles keep all threads at work.
  const int row = static_cast<int>(state.row), left = settings.height - row;
  const double tileRows = pixelPasses / (static_cast<double>(settings.width) * kTileSize);
  const int rows = tileRows * kTileSize >= left
                       ? left
                       : std::min(left, std::max(1, static_cast<int>(tileRows)) * kTileSize);
  job.region = {0, row, settings.width, rows};
  job.rays = raysOfPass(settings, state.firstRay);
  return job;
}

void advance(const RenderSettings& settings, const RenderJob& job, RenderState& state) {
  state.row += static_cast<std::uint64_t>(job.region.height);
  if (state.row < static_cast<std::uint64_t>(settings.height)) return;
  state.row = 0;
  state.firstRay += job.rays;
  if (settings.replicates == 1 || state.firstRay < settings.raysPerReplicate()) return;
  addReplicate(state.replicates, state.film);
  std::fill(state.film.begin(), state.film.end(), FilmPixel{});
  ++state.replicate;
  state.firstRay = 0;
}

}  // namespace pathmark
