#include "host/adaptive_picture.h"

#include "film/image_file.h"
#include "host/adaptive_render.h"
#include "host/exit_code.h"
#include "host/interrupt.h"
#include "host/invalid_origin.h"
#include "host/progress_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

ImageOrigin originOf(const Coursework& coursework, const LoadedScene& scene,
                     const AdaptiveRequest& request, const AdaptivePicture& picture) {
  ImageOrigin origin;
  origin.scene = scene.name;
  origin.sceneHash = sceneHash(scene);
  origin.coursework = coursework.name;
  origin.raysPerPixel = picture.rendered.raysPerPixel;
  origin.raysPerPass = AdaptiveRender::kPilotRays;
  origin.replicates = AdaptiveRender::kFilms;
  origin.pixelsPerBlock = request.options.sharing.pixels;
  origin.seed = request.options.seed;
  origin.sampler = nameOf(request.options.sampler);
  origin.paths = settingsFor(scene, request.options).paths;
  origin.seconds = picture.rendered.seconds;
  origin.targetError = request.targetError;
  if (!picture.errors.relative.empty()) origin.worstTileError = picture.errors.worst();
  return origin;
}

// Numbers in files to compute with, grey in pictures: white is the most.
void writeRayMap(const fs::path& file, const AdaptivePicture& picture) {
  const bool toLookAt = imageEnding(file) == ".png";
  const float most = *std::max_element(picture.raysPerPixel.begin(), picture.raysPerPixel.end());
  Image map{.width = picture.rendered.image.width, .height = picture.rendered.image.height};
  for (const float rays : picture.raysPerPixel)
    map.rgb.insert(map.rgb.end(), 3, toLookAt ? rays / most : rays);
  writeImage(file, map, 1.0);
  fmt::print("{}: rays per pixel of each tile, {} at most{}\n", file.string(), most,
             toLookAt ? ", which is white" : "");
}

// By what the pilot told: a tile that was held at the most may have come within the error all the
// same, by luck, and another have missed it.
std::string heldTilesSentence(std::size_t held, std::size_t tiles, std::uint64_t mostRays) {
  if (held == 0) return {};
  return fmt::format(
      "By what the first rays told, {} of the {} tiles would have needed more than {} rays per "
      "pixel, which is the most.\n",
      held, tiles, mostRays);
}

void printReached(const AdaptiveRequest& request, const AdaptivePicture& picture) {
  if (picture.errors.relative.empty()) return;
  const auto within = std::count_if(picture.errors.relative.begin(), picture.errors.relative.end(),
                                    [&](double error) { return error <= request.targetError; });
  fmt::print(
      "Error of tiles of {0}x{0} pixels: {1:.2f} % in the median, {2:.2f} % in the worst; {3} "
      "of {4} within {5:g} %.\n",
      kTileSize, 100.0 * picture.errors.median(), 100.0 * picture.errors.worst(), within,
      picture.errors.relative.size(), 100.0 * request.targetError);
  fmt::print("{}", heldTilesSentence(picture.tilesAtMost, picture.errors.relative.size(),
                                     AdaptiveRender::mostRays(request.options.raysPerPixel)));
}

void noteRaysLeft(std::uint64_t allowed) {
  const std::uint64_t most = AdaptiveRender::mostRays(allowed);
  if (most == allowed) return;
  fmt::print(
      stderr,
      "Of the {} rays per pixel that are allowed at most {} are made: the picture is made in "
      "{} films, in passes of {} rays.\n",
      allowed, most, AdaptiveRender::kFilms, AdaptiveRender::kPilotRays);
}

// Who has interrupted a render does not wait for the function's name. Where a tile got fewer rays,
// those that it did not get tell the same.
std::string originSentence(const Coursework& coursework, const LoadedScene& scene,
                           const AdaptiveRequest& request, const RenderedImage& rendered) {
  if (!rendered.complete) return {};
  const std::uint64_t most = AdaptiveRender::mostRays(request.options.raysPerPixel);
  const std::string sentence = invalidOrigin(
      coursework, scene, settingsFor(scene, request.options),
      {AdaptiveRender::kFilms, most / AdaptiveRender::kFilms, AdaptiveRender::kPilotRays},
      rendered.invalid.firstPixel);
  return sentence.empty() ? sentence : sentence + "\n";
}

}  // namespace

double parseTargetError(const std::string& text) {
  const bool percent = text.ends_with('%');
  double value = 0.0;
  const char* end = text.data() + text.size() - (percent ? 1 : 0);
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (percent) value /= 100.0;
  if (error != std::errc{} || stop != end || !(value >= 1e-5 && value <= 1.0))
    throw UsageError(fmt::format(
        "--target-error {}: the error is a share from 0.001% to 100%, such as 1% or 0.01.", text));
  return value;
}

void refuseFewRays(std::uint64_t raysPerPixel) {
  constexpr auto kLeast = std::uint64_t{AdaptiveRender::kFilms} * AdaptiveRender::kPilotRays;
  if (raysPerPixel < kLeast)
    throw UsageError(
        fmt::format("--target-error: {} rays per pixel are fewer than the {} that the error is "
                    "estimated with.",
                    raysPerPixel, kLeast));
}

int renderToTarget(const Coursework& coursework, const LoadedScene& scene,
                   const AdaptiveRequest& request) {
  noteRaysLeft(request.options.raysPerPixel);
  StubReport stubs;
  AdaptivePicture picture;
  {
    ProgressBar bar(fmt::format("{}, {}", scene.name, coursework.name));
    WorkerProcess worker(workerOptions(coursework, request.options, bar));
    stubs = makeStubReport(worker.stubs());
    worker.loadScene(scene.flat);
    AdaptiveRender render(worker, settingsFor(scene, request.options), request.targetError);
    render.run([&](const RenderStatus& status) {
      bar.show(status);
      return !interrupted();
    });
    picture = render.picture();
  }
  const RenderedImage& rendered = picture.rendered;
  if (!(rendered.raysPerPixel > 0.0)) {
    fmt::print(stderr, "Interrupted before the first ray: no picture was written.\n");
    return kInterrupted;
  }
  writeImage(request.output, rendered.image, scene.exposure,
             originOf(coursework, scene, request, picture));
  fmt::print("{}: {}x{}, {:.1f} rays per pixel in the mean, {:.2f} s, {:.1f} Mrays/s, with {}\n",
             request.output.string(), rendered.image.width, rendered.image.height,
             rendered.raysPerPixel, rendered.seconds,
             static_cast<double>(rendered.raysTraced) / rendered.seconds * 1e-6, coursework.name);
  fmt::print("{}", unwrittenNote(scene, request.options.estimator, stubs));
  printReached(request, picture);
  if (!request.rayMap.empty()) writeRayMap(request.rayMap, picture);
  std::fflush(stdout);
  const std::string invalid = invalidSentence(rendered, request.options.estimator);
  if (!invalid.empty())
    fmt::print(stderr, "{}\n{}", invalid, originSentence(coursework, scene, request, rendered));
  if (!rendered.complete)
    fmt::print(stderr, "Interrupted: the picture has the rays that there was time for.\n");
  return !invalid.empty() ? kCourseworkFault : rendered.complete ? kSuccess : kInterrupted;
}

}  // namespace pathmark
