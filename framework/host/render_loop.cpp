#include "host/render_loop.h"

#include <algorithm>
#include <cmath>

namespace pathmark {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr const char* kScribbled =
    "The film holds values that the framework never writes: coursework must not write outside its "
    "own variables.";

// The film as it is now, checked: a worker may write anything into it at any time.
std::vector<FilmPixel> copyFilm(const SharedFilm& film, std::uint64_t rays, WorkerProcess& worker) {
  std::vector<FilmPixel> pixels(film.pixels().begin(), film.pixels().end());
  for (const FilmPixel& pixel : pixels) {
    const bool sane = std::isfinite(pixel.sum[0]) && std::isfinite(pixel.sum[1]) &&
                      std::isfinite(pixel.sum[2]) && pixel.rays >= 0.0 &&
                      pixel.rays <= static_cast<double>(rays);
    if (!sane) worker.refuseAnswer(kScribbled);
  }
  return pixels;
}

}  // namespace

std::uint32_t raysPerPass(std::uint64_t raysPerPixel) {
  constexpr std::uint64_t kLargestPass = 64;
  return static_cast<std::uint32_t>(std::min(raysPerPixel, kLargestPass));
}

RenderedImage renderImage(WorkerProcess& worker, const RenderSettings& settings,
                          const std::function<bool(const RenderStatus&)>& onStatus) {
  SharedFilm film(settings.width, settings.height);
  RenderedImage result;
  RenderJob job;
  job.estimator = settings.estimator;
  job.threads = settings.threads;
  job.seed = settings.seed;
  job.raysPerPass = raysPerPass(settings.raysPerPixel);
  job.region = {0, 0, settings.width, settings.height};

  const auto started = Clock::now();
  const double pixels = static_cast<double>(settings.width) * settings.height;
  const double allRays = pixels * static_cast<double>(settings.raysPerPixel);
  std::uint64_t passes = 1;
  while (result.complete && job.firstRay < settings.raysPerPixel) {
    job.rays =
        std::min<std::uint64_t>(passes * job.raysPerPass, settings.raysPerPixel - job.firstRay);
    const auto before = Clock::now();
    const RenderResult made = worker.render(job, film, [&](const RenderProgress& p) {
      const double done =
          pixels * static_cast<double>(job.firstRay) +
          static_cast<double>(p.pixelPassesDone) * static_cast<double>(job.raysPerPass);
      const RenderStatus status{std::min(done / allRays, 1.0), secondsSince(started),
                                result.raysTraced + p.raysTraced};
      result.complete = onStatus(status) && result.complete;
      return result.complete;
    });
    result.raysTraced += made.raysTraced;
    result.invalid.add(made.invalid);
    job.firstRay += job.rays;

    // All pixels get their passes of one request before any gets those of the next, so that an
    // interrupted image is even; a request lasts about a second, so that its overhead is nothing.
    constexpr double kRequestSeconds = 1.0;
    const double seconds = std::max(secondsSince(before), 1e-3);
    const double fitting = static_cast<double>(passes) * kRequestSeconds / seconds;
    passes =
        static_cast<std::uint64_t>(std::clamp(fitting, 1.0, 4.0 * static_cast<double>(passes)));
  }
  const std::vector<FilmPixel> final = copyFilm(film, settings.raysPerPixel, worker);
  result.image = imageFromFilm(settings.width, settings.height, final);
  double rays = static_cast<double>(result.invalid.count()) * job.raysPerPass;
  for (const FilmPixel& pixel : final) rays += pixel.rays;
  // Rays are missing only where their pass was reported as invalid.
  if (result.complete && rays < allRays) worker.refuseAnswer(kScribbled);
  result.raysPerPixel =
      result.complete ? static_cast<double>(settings.raysPerPixel) : rays / pixels;
  result.seconds = secondsSince(started);
  return result;
}

}  // namespace pathmark
