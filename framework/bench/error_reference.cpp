#include "bench/error_reference.h"

#include "bench/error_estimators.h"
#include "bench/interrupted_run.h"
#include "film/image_file.h"
#include "host/build_config.h"
#include "host/content_hash.h"
#include "host/reference.h"

#include <fmt/format.h>

namespace pathmark::bench {

namespace fs = std::filesystem;

namespace {

// Of nobody else's: noise in common with what is measured would hide errors.
constexpr std::uint64_t kSeed = 0x6572726f72726566;  // "errorref"
constexpr std::uint32_t kReplicates = 16;

BenchReference asReference(ImageFile file) {
  BenchReference reference{std::move(file.image), file.origin.replicates, {}};
  reference.own = ownDeviation(reference.image, reference.replicates);
  return reference;
}

fs::path keptFile(const LoadedScene& scene, const Coursework& coursework, Estimator estimator,
                  std::uint64_t rays) {
  const fs::path folder = fs::path(build::kBuildFolder) / "error-references";
  fs::create_directories(folder);
  return folder / fmt::format("{}_{}.exr", scene.name,
                              contentHash(fmt::format("{} {} {} {}", sceneHash(scene),
                                                      coursework.worker.string(), rays,
                                                      static_cast<int>(estimator))));
}

// What smooth surfaces mirror of large lights, tracePath hardly ever finds: its picture would lack
// that, and its own error would not tell.
Estimator bestEstimator(const Coursework& coursework) {
  return whatIsUnwritten(coursework, {.estimator = Estimator::kMis}).empty() ? Estimator::kMis
                                                                             : Estimator::kPath;
}

BenchReference make(const LoadedScene& scene, const Coursework& coursework, Estimator estimator,
                    std::uint64_t rays) {
  RenderOptions options;
  options.estimator = estimator;
  options.raysPerPixel = rays - rays % kReplicates;
  options.replicates = kReplicates;
  options.seed = kSeed;
  options.secondsWithoutAnswer = 60.0;
  fmt::print(stderr, "Making a reference of {}, {} x {} pixels, with {}{} and {} rays per pixel.\n",
             scene.name, scene.flat.camera.width, scene.flat.camera.height, coursework.name,
             estimator == Estimator::kMis ? ", part 8," : "", options.raysPerPixel);
  const RenderedImage made = renderScene(coursework, scene, options).rendered;
  if (!made.complete) throw Interrupted{};
  ImageFile file{made.image, {}};
  file.origin.scene = scene.name;
  file.origin.sceneHash = sceneHash(scene);
  file.origin.coursework = coursework.name;
  file.origin.raysPerPixel = made.raysPerPixel;
  file.origin.replicates = kReplicates;
  file.origin.seed = kSeed;
  writeImage(keptFile(scene, coursework, estimator, rays), file.image, 1.0, file.origin);
  return asReference(std::move(file));
}

BenchReference fromFile(const LoadedScene& scene, const std::string& file) {
  ImageFile image = readImage(file);
  const FlatCamera& camera = scene.flat.camera;
  if (image.image.width != static_cast<int>(camera.width) ||
      image.image.height != static_cast<int>(camera.height))
    throw UsageError(fmt::format("--reference {}: it has {} x {} pixels, and {} has {} x {}.", file,
                                 image.image.width, image.image.height, scene.name, camera.width,
                                 camera.height));
  return asReference(std::move(image));
}

}  // namespace

BenchReference referenceFor(const LoadedScene& scene, const Coursework& coursework,
                            std::uint64_t raysPerPixel, const std::string& file) {
  if (!file.empty()) return fromFile(scene, file);
  std::optional<ImageFile> shipped = readReference(scene);
  if (shipped && !shipped->image.variance.empty()) return asReference(std::move(*shipped));
  const Estimator estimator = bestEstimator(coursework);
  const fs::path kept = keptFile(scene, coursework, estimator, raysPerPixel);
  if (fs::exists(kept)) {
    ImageFile image = readImage(kept);
    if (fits(image, scene) && !image.image.variance.empty()) return asReference(std::move(image));
  }
  return make(scene, coursework, estimator, raysPerPixel);
}

}  // namespace pathmark::bench
