#include "host/render_picture.h"

#include "film/image_file.h"
#include "host/content_hash.h"
#include "host/exit_code.h"
#include "host/invalid_origin.h"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <utility>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

// Of a worker's program: what it was compiled from, the framework's part included.
std::string programHash(const fs::path& program) {
  std::ifstream in(program, std::ios::binary);
  return contentHash(std::string(std::istreambuf_iterator<char>(in), {}));
}

CheckpointIdentity identityOf(const Coursework& coursework, const LoadedScene& scene,
                              const RenderOptions& options) {
  return {sceneHash(scene), programHash(coursework.worker), scene.flat.maxBounces,
          settingsFor(scene, options)};
}

ImageOrigin originOf(const Coursework& coursework, const LoadedScene& scene,
                     const CheckpointIdentity& identity, const RenderedImage& rendered) {
  const RenderSettings& settings = identity.settings;
  ImageOrigin origin;
  origin.scene = scene.name;
  origin.sceneHash = identity.scene;
  origin.coursework = coursework.name;
  origin.raysPerPixel = rendered.raysPerPixel;
  origin.raysPerPass = settings.raysPerPass();
  origin.replicates = settings.replicates;
  origin.pixelsPerBlock = settings.sharing.pixels;
  origin.seed = settings.seed;
  origin.sampler = nameOf(settings.sampler);
  origin.paths = settings.paths;
  origin.seconds = rendered.seconds;
  return origin;
}

RenderOutcome renderWithCheckpoints(const Coursework& coursework, const LoadedScene& scene,
                                    const RenderOptions& options, CheckpointKeeper& keeper) {
  RenderState state = keeper.begin();
  try {
    return renderScene(coursework, scene, options, std::move(state),
                       [&](const RenderState& made) { return keeper.afterStep(made); });
  } catch (const WorkerError&) {
    fmt::print(stderr, "{}", keeper.whatIsLeft());
    throw;
  }
}

std::string raysMade(const RenderedImage& rendered) {
  return fmt::format("{:.{}f}", rendered.raysPerPixel, rendered.complete ? 0 : 1);
}

void printPicture(const fs::path& output, const Coursework& coursework,
                  const RenderOutcome& outcome, const std::string& missing) {
  const RenderedImage& rendered = outcome.rendered;
  fmt::print("{}: {}x{}, {} rays per pixel, {:.2f} s, {:.1f} Mrays/s, with {}\n", output.string(),
             rendered.image.width, rendered.image.height, raysMade(rendered), rendered.seconds,
             static_cast<double>(rendered.raysTraced) / rendered.seconds * 1e-6, coursework.name);
  fmt::print("{}", missing);
  std::fflush(stdout);
}

// Who has interrupted a render does not wait for the function's name.
std::string originSentence(const Coursework& coursework, const LoadedScene& scene,
                           const RenderOptions& options, const RenderedImage& rendered) {
  if (rendered.invalid.count() == 0 || !rendered.complete) return {};
  const RenderSettings settings = settingsFor(scene, options);
  const std::string sentence =
      invalidOrigin(coursework, scene, settings,
                    {settings.replicates, settings.raysPerReplicate(), settings.raysPerPass()},
                    rendered.invalid.firstPixel);
  return sentence.empty() ? sentence : sentence + "\n";
}

// What is wrong with the picture, and how the render can be gone on with.
int conclude(const RenderOutcome& outcome, const RenderOptions& options, const std::string& origin,
             CheckpointKeeper& keeper) {
  const RenderedImage& rendered = outcome.rendered;
  const std::string invalid = invalidSentence(rendered, options.estimator);
  if (!invalid.empty()) fmt::print(stderr, "{}\n{}", invalid, origin);
  if (!rendered.complete) {
    fmt::print(stderr, "Interrupted: the picture has {} of {} rays per pixel.\n",
               raysMade(rendered), options.raysPerPixel);
    fmt::print(stderr, "{}", keeper.onInterrupt(outcome.state, rendered.raysPerPixel));
  } else {
    fmt::print(stderr, "{}", keeper.onFinish(outcome.state));
  }
  return !invalid.empty() ? kCourseworkFault : rendered.complete ? kSuccess : kInterrupted;
}

}  // namespace

void refuseUnequalReplicates(std::uint64_t rays, std::uint64_t replicates) {
  if (rays % replicates == 0) return;
  const std::uint64_t above = (rays / replicates + 1) * replicates, below = above - replicates;
  throw UsageError(fmt::format(
      "--replicates {}: {} rays per pixel cannot be parted into so many equal groups; {} can.",
      replicates, rays,
      below == 0 ? fmt::format("{}", above) : fmt::format("{} and {}", below, above)));
}

int renderPicture(const Coursework& coursework, const LoadedScene& scene,
                  const PictureRequest& request) {
  const RenderOptions& options = request.options;
  const CheckpointIdentity identity = identityOf(coursework, scene, options);
  CheckpointKeeper keeper(request.output, identity, request.checkpoints);
  const RenderOutcome outcome = renderWithCheckpoints(coursework, scene, options, keeper);
  const RenderedImage& rendered = outcome.rendered;
  if (!(rendered.raysPerPixel > 0.0)) {
    fmt::print(stderr, "Interrupted before the first ray: no picture was written.\n");
    return kInterrupted;
  }
  try {
    writeImage(request.output, rendered.image, scene.exposure,
               originOf(coursework, scene, identity, rendered));
  } catch (const ImageError&) {
    fmt::print(stderr, "{}", keeper.rescue(outcome.state));
    throw;
  }
  printPicture(request.output, coursework, outcome,
               unwrittenNote(scene, options.estimator, outcome.stubs));
  return conclude(outcome, options, originSentence(coursework, scene, options, rendered), keeper);
}

}  // namespace pathmark
