#include "marking/pictures.h"

#include "film/image_formats.h"
#include "film/signed_picture.h"
#include "film/usable_pixels.h"
#include "host/render_loop.h"
#include "host/session.h"
#include "host/worker_clock.h"
#include "sampling/mix.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace pathmark::marking {

namespace {

// Of the curve of errors.
constexpr std::array<std::uint64_t, 4> kRayCounts{1, 4, 16, 64};

// In the picture of differences, at least: what is nothing but noise stays pale.
constexpr double kLeastScale = 0.05;

RenderSettings settingsOf(const MarkingScene& scene, std::uint64_t seed, unsigned threads) {
  RenderSettings settings;
  settings.width = static_cast<int>(scene.flat.camera.width);
  settings.height = static_cast<int>(scene.flat.camera.height);
  settings.threads = threads;
  settings.seed = seed;
  settings.estimator = scene.estimator;
  return settings;
}

RenderedImage renderAll(WorkerProcess& worker, const RenderSettings& settings) {
  return renderImage(worker, settings, [](const RenderStatus&) { return true; });
}

struct Made {
  Measured measured;
  InvalidPixels invalid;
  double pixelPasses = 0.0;
};

// The scene must have been loaded.
Made measure(WorkerProcess& worker, const MarkingScene& scene, std::uint64_t seed, unsigned threads,
             const Effort& effort) {
  RenderSettings settings = settingsOf(scene, seed, threads);
  settings.raysPerPixel = effort.raysPerPixel;
  settings.replicates = effort.replicates;
  const double before = cpuSecondsOf(worker.pid());
  const RenderedImage rendered = renderAll(worker, settings);
  const double cpuSeconds = cpuSecondsOf(worker.pid()) - before;
  // The worker counts its rays itself; each camera ray is one of them.
  const auto pixels = static_cast<double>(settings.width) * settings.height;
  const double cameraRays = pixels * static_cast<double>(effort.raysPerPixel);
  const double rays = std::max(static_cast<double>(rendered.raysTraced), cameraRays);
  return {{rendered.image, rays, effort.replicates, cpuSeconds},
          rendered.invalid,
          cameraRays / settings.raysPerPass()};
}

double brightnessOf(const Image& image) {
  double sum = 0.0;
  for (const float x : image.rgb) sum += double{x};
  return sum / static_cast<double>(std::max<std::size_t>(image.rgb.size(), 1));
}

// Root mean square of what differs from the reference, less the reference's own noise, relative to
// its brightness.
double errorAgainst(const Image& image, const Image& reference) {
  double sum = 0.0;
  for (std::size_t v = 0; v < image.rgb.size(); ++v) {
    const double d = double{image.rgb[v]} - double{reference.rgb[v]};
    const double own = reference.variance.empty() ? 0.0 : double{reference.variance[v]};
    sum += d * d - (std::isfinite(own) ? own : 0.0);
  }
  const double mean = sum / static_cast<double>(image.rgb.size());
  return std::sqrt(std::max(mean, 0.0)) / std::max(brightnessOf(reference), 1e-30);
}

// The scene must have been loaded.
std::vector<double> convergenceOf(WorkerProcess& worker, const MarkingScene& scene,
                                  const Image& reference, std::uint64_t seed, unsigned threads) {
  std::vector<double> errors;
  for (const std::uint64_t rays : kRayCounts) {
    RenderSettings settings = settingsOf(scene, mix(seed + kGolden * rays), threads);
    settings.raysPerPixel = rays;
    errors.push_back(errorAgainst(renderAll(worker, settings).image, reference));
  }
  return errors;
}

void drawDifference(Compared& compared, const Image& yours, const Image& reference) {
  const UsablePixels pixels = findUsablePixels(yours, reference);
  const double brightness = std::max(brightnessOf(reference), 1e-30);
  std::vector<float> values = largestOfChannels(differenceImage(yours, reference), pixels);
  for (float& value : values) value = static_cast<float>(double{value} / brightness);
  compared.record.scale = std::max(fullColour(values), kLeastScale);
  compared.files.difference =
      encodeSignedPng(yours.width, yours.height, values, compared.record.scale);
}

}  // namespace

std::string invalidWords(const InvalidPixels& invalid, double values) {
  if (invalid.count() == 0) return {};
  const double percent = 100.0 * static_cast<double>(invalid.count()) / values;
  return fmt::format(
      "{} % of its values are no radiance ({})",
      percent < 9.95 ? fmt::format("{:.2g}", percent) : fmt::format("{:.0f}", percent),
      invalidKinds(invalid));
}

Measured renderMeasured(WorkerProcess& worker, const MarkingScene& scene, std::uint64_t seed,
                        unsigned threads, const Effort& effort) {
  worker.loadScene(scene.flat);
  return measure(worker, scene, seed, threads, effort).measured;
}

const Solved& SolvedPictures::of(const MarkingScene& scene, bool withConvergence,
                                 unsigned threads) {
  Entry* entry = nullptr;
  {
    const std::lock_guard lock(mutex_);
    entry = &entries_[fmt::format("{} {} {}", scene.name, static_cast<int>(scene.estimator),
                                  withConvergence)];
  }
  std::call_once(entry->made, [&] {
    const std::uint64_t seed = mix(seed_ + kGolden);
    try {
      const std::unique_ptr<WorkerProcess> worker = start_();
      entry->solved.picture = renderMeasured(*worker, scene, seed, threads);
      if (withConvergence)
        entry->solved.convergence =
            convergenceOf(*worker, scene, entry->solved.picture.image, mix(seed), threads);
    } catch (const WorkerError& e) {
      // Nobody's coursework is to blame.
      throw std::runtime_error(std::string("The solutions failed: ") + e.what());
    }
  });
  return entry->solved;
}

Compared comparePicture(WorkerProcess& worker, const MarkingScene& scene, SolvedPictures& solved,
                        const CompareOptions& options) {
  const Solved& reference = solved.of(scene, options.convergence, options.threads);
  Compared compared;
  record::PictureRecord& record = compared.record;
  record.scene = scene.name;
  record.width = static_cast<int>(scene.flat.camera.width);
  record.height = static_cast<int>(scene.flat.camera.height);
  record.raysPerPixel = static_cast<double>(kRaysPerPixel);
  try {
    worker.loadScene(scene.flat);
    const Made made = measure(worker, scene, options.seed, options.threads, {});
    const Measured &yours = made.measured, &theirs = reference.picture;
    compared.image = yours.image;
    record.bias = tileBias(yours.image, theirs.image);
    record.meanError = meanErrors(yours.image, theirs.image);
    record.efficiency = efficiencyOver(yours, theirs);
    record.pValues = pValueHistogram(yours, theirs);
    record.cpuSeconds = yours.cpuSeconds;
    record.cpuSecondsOfSolutions = theirs.cpuSeconds;
    record.invalid = invalidWords(made.invalid, made.pixelPasses);
    if (options.convergence) {
      record.convergence.raysPerPixel.assign(kRayCounts.begin(), kRayCounts.end());
      record.convergence.solutions = reference.convergence;
      record.convergence.yours =
          convergenceOf(worker, scene, theirs.image, mix(options.seed), options.threads);
    }
    compared.files.yours = encodePng(yours.image, scene.exposure);
    compared.files.reference = encodePng(theirs.image, scene.exposure);
    drawDifference(compared, yours.image, theirs.image);
  } catch (const WorkerError& e) {
    record.failure = e.what();
  }
  return compared;
}

}  // namespace pathmark::marking
