#include "host/render_loop.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pathmark {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// The first step's: hundredths of a second for a scene of the coursework, and not long for one of
// which every ray takes a thousand times as much.
constexpr double kFirstPixelPasses = 1024.0;

double allRays(const RenderSettings& settings) {
  return static_cast<double>(settings.pixels()) * static_cast<double>(settings.raysPerPixel);
}

double fractionMade(const RenderSettings& settings, const RenderState& state) {
  return static_cast<double>(raysMade(settings, state)) / allRays(settings);
}

double sumOfRays(std::span<const FilmPixel> film) {
  double rays = 0.0;
  for (const FilmPixel& pixel : film) rays += pixel.rays;
  return rays;
}

double pixelPassesOf(const RenderJob& job) {
  const double passes = std::ceil(static_cast<double>(job.rays) / job.raysPerPass);
  return passes * job.region.width * job.region.height;
}

}  // namespace

ImageRender::ImageRender(WorkerProcess& worker, const RenderSettings& settings, RenderState state)
    : worker_(worker),
      settings_(settings),
      state_(std::move(state)),
      fractionBefore_(fractionMade(settings, state_)),
      secondsBefore_(state_.seconds),
      film_(settings.width, settings.height),
      pixelPasses_(kFirstPixelPasses) {
  if (!state_.begun()) state_.film.assign(settings.pixels(), FilmPixel{});
}

// The worker adds to the sums that are there, in the order of the passes: the bits do not depend
// on where one step ends and the next begins.
bool ImageRender::step(const OnStatus& onStatus, const StepSize& size) {
  remainder_.reset();
  const RenderJob job =
      nextJob(settings_, state_,
              std::min(pixelPasses_, size.mostPasses * static_cast<double>(settings_.pixels())));
  const auto rows = rowsOf(job.region);
  const std::span<FilmPixel> shared = film_.pixels().subspan(
      static_cast<std::size_t>(rows.data() - state_.film.data()), rows.size());
  std::copy(rows.begin(), rows.end(), shared.begin());

  const auto started = Clock::now();
  const double madeBefore = static_cast<double>(raysMade(settings_, state_));
  bool going = true;
  const RenderResult made = worker_.render(job, film_, [&](const RenderProgress& p) {
    const double now = static_cast<double>(p.pixelPassesDone) * job.raysPerPass;
    const double fraction = std::min((madeBefore + now) / allRays(settings_), 1.0);
    going = onStatus({fraction, fractionBefore_, state_.seconds + secondsSince(started),
                      secondsBefore_, state_.raysTraced + p.raysTraced}) &&
            going;
    return going;
  });
  const double seconds = secondsSince(started);
  if (!going) {
    Remainder remainder{job.region, std::vector<FilmPixel>(rows.size()), made, seconds};
    takeRows(job, made, false, remainder.film);
    remainder_ = std::move(remainder);
    return false;
  }
  // First all of it is looked at, so that a refusal leaves the state as it was: that needs less
  // memory than a copy.
  takeRows(job, made, true, {});
  takeRows(job, made, true, rows);
  state_.raysTraced += made.raysTraced;
  state_.invalid.add(made.invalid);
  state_.seconds += seconds;
  advance(settings_, job, state_);

  const double fitting = pixelPassesOf(job) * size.seconds / std::max(seconds, 1e-3);
  pixelPasses_ = std::clamp(fitting, 1.0, 4.0 * pixelPasses_);
  return true;
}

RenderedImage ImageRender::image() const {
  RenderedImage result;
  result.invalid = state_.invalid;
  result.raysTraced = state_.raysTraced;
  result.seconds = state_.seconds;
  result.complete = finished();
  std::vector<FilmPixel> newest;
  std::span<const FilmPixel> film = state_.film;
  if (remainder_) {
    newest = state_.film;
    const auto top = static_cast<std::ptrdiff_t>(remainder_->region.top) * settings_.width;
    std::copy(remainder_->film.begin(), remainder_->film.end(), newest.begin() + top);
    film = newest;
    result.invalid.add(remainder_->made.invalid);
    result.raysTraced += remainder_->made.raysTraced;
    result.seconds += remainder_->seconds;
  }
  result.image = imageFromReplicates(settings_.width, settings_.height, state_.replicates, film);
  const double rays = sumOfRays(film) + sumOfRays(state_.replicates.film) +
                      static_cast<double>(result.invalid.count()) * settings_.raysPerPass();
  result.raysPerPixel = result.complete ? static_cast<double>(settings_.raysPerPixel)
                                        : rays / static_cast<double>(settings_.pixels());
  return result;
}

// Regions are whole rows.
std::span<FilmPixel> ImageRender::rowsOf(const PixelRegion& region) {
  const auto width = static_cast<std::size_t>(settings_.width);
  return std::span(state_.film)
      .subspan(static_cast<std::size_t>(region.top) * width,
               static_cast<std::size_t>(region.height) * width);
}

// The film's rows as they are now, checked, into `to` unless it is empty: a worker may write
// anything into them at any time, so that what is kept is what was looked at. In a whole job, rays
// are missing only where their pass was reported as invalid.
void ImageRender::takeRows(const RenderJob& job, const RenderResult& made, bool whole,
                           std::span<FilmPixel> to) {
  const std::span<const FilmPixel> before = rowsOf(job.region);
  const std::span<const FilmPixel> now = std::as_const(film_).pixels().subspan(
      static_cast<std::size_t>(before.data() - state_.film.data()), before.size());
  const auto most = static_cast<double>(job.firstRay + job.rays);
  const double due = static_cast<double>(before.size()) * static_cast<double>(job.rays);
  double rays = static_cast<double>(made.invalid.count()) * job.raysPerPass;
  std::vector<FilmPixel> row(static_cast<std::size_t>(settings_.width));
  for (std::size_t first = 0; first < before.size(); first += row.size()) {
    std::copy_n(now.begin() + static_cast<std::ptrdiff_t>(first), row.size(), row.begin());
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (!isPossible(row[k], most)) worker_.refuseAnswer(kScribbled);
      rays += row[k].rays - before[first + k].rays;
    }
    if (!to.empty())
      std::copy(row.begin(), row.end(), to.begin() + static_cast<std::ptrdiff_t>(first));
  }
  if (whole && rays < due) worker_.refuseAnswer(kScribbled);
}

RenderedImage renderImage(WorkerProcess& worker, const RenderSettings& settings,
                          const OnStatus& onStatus) {
  ImageRender render(worker, settings);
  while (!render.finished() && render.step(onStatus)) {
  }
  return render.image();
}

}  // namespace pathmark
