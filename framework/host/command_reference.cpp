// pathmark reference: images of the shipped scenes with little noise, to compare others with.
#include "film/atomic_file.h"
#include "film/image_file.h"
#include "film/image_formats.h"
#include "film/own_error.h"
#include "host/blob_file.h"
#include "host/build_config.h"
#include "host/commands.h"
#include "host/display_path.h"
#include "host/exit_code.h"
#include "host/interrupt.h"
#include "host/options.h"
#include "host/reference.h"
#include "host/render_picture.h"
#include "host/session.h"
#include "scene/limits.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

// Nobody's own: noise that a picture and its reference had in common would hide differences.
constexpr std::uint64_t kSeed = 0x7265666572656e63;  // "referenc"

struct ReferenceArguments {
  std::vector<std::string> scenes;
  std::uint64_t raysPerPixel = 1024;
  std::uint32_t replicates = 16;
  std::string sampler = "sobol";
  bool check = false;
  bool again = false;
};

void printHead() {
  fmt::print("{:<20} {:>9} {:>14} {:>10} {:>13} {:>8}\n", "scene", "pixels", "rays per pixel",
             "mean, +- %", "pixels, +- %", "KB");
}

void printRow(const std::string& name, const ImageFile& file) {
  const OwnError error = ownError(file.image);
  fmt::print("{:<20} {:>9} {:>14} {:>10.3f} {:>13.2f} {:>8}\n", name,
             fmt::format("{}x{}", file.image.width, file.image.height), file.origin.raysPerPixel,
             100.0 * error.ofMean, 100.0 * error.ofPixels,
             fs::file_size(referenceFile(name)) / 1024);
  std::fflush(stdout);
}

void refuseUnknownScenes(const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (!fs::exists(shippedSceneFile(name)))
      throw UsageError(fmt::format("{} is no scene in scenes/: only those have references.", name));
}

LoadedScene load(const std::string& name) {
  const fs::path file = shippedSceneFile(name);
  if (needsShippedBlobFile(file)) makeShippedBlobFile();
  return loadScene(file);
}

bool isGoodEnough(const ImageFile& file, const ReferenceArguments& arguments) {
  return !file.image.variance.empty() &&
         file.origin.raysPerPixel >= static_cast<double>(arguments.raysPerPixel);
}

// What has been rendered, with all its bits, unless it is of another scene or has fewer rays.
std::optional<ImageFile> readRendered(const fs::path& file, const LoadedScene& scene,
                                      const ReferenceArguments& arguments) {
  if (arguments.again || !fs::exists(file)) return std::nullopt;
  ImageFile rendered = readImage(file);
  return isGoodEnough(rendered, arguments) && fits(rendered, scene)
             ? std::optional(std::move(rendered))
             : std::nullopt;
}

// Renders into the build folder, where an interrupted render is gone on with, and stores what is
// not noise.
int make(const Coursework& coursework, const LoadedScene& scene,
         const ReferenceArguments& arguments) {
  const fs::path folder = fs::path(build::kBuildFolder) / "references";
  fs::create_directories(folder);
  fs::create_directories(referenceFile(scene.name).parent_path());
  PictureRequest request;
  request.output = folder / (scene.name + ".exr");
  request.options.raysPerPixel = arguments.raysPerPixel;
  request.options.replicates = arguments.replicates;
  // What smooth surfaces mirror of large lights, points on the lights hardly ever find: a reference
  // by tracePath would lack it, and its own error would not tell.
  request.options.estimator = Estimator::kMis;
  request.options.seed = kSeed;
  request.options.sampler = findSampler(arguments.sampler);
  request.checkpoints.resume = fs::exists(request.output.string() + ".checkpoint");
  request.checkpoints.resumeOnlyIfPossible = true;
  std::optional<ImageFile> rendered = readRendered(request.output, scene, arguments);
  if (!rendered) {
    if (const int code = renderPicture(coursework, scene, request); code != kSuccess) return code;
    rendered = readImage(request.output);
  }
  writeFileAtomically(referenceFile(scene.name),
                      encodeExr(rendered->image, rendered->origin, ExrBits::kAboveNoise));
  return kSuccess;
}

int makeAll(const ReferenceArguments& arguments) {
  if (solvedCoursework() != "solutions")
    throw UsageError(
        "References are made with the solutions, which are not here; --check looks at those that "
        "there are.");
  const Coursework coursework = prepareCoursework("solutions");
  for (const std::string& name : arguments.scenes) {
    const LoadedScene scene = load(name);
    const std::optional<ImageFile> there = readReference(scene);
    if (!arguments.again && there && isGoodEnough(*there, arguments)) continue;
    if (const int code = make(coursework, scene, arguments); code != kSuccess) return code;
    if (interrupted()) return kInterrupted;
  }
  return kSuccess;
}

// The table. Returns whether every scene has a reference that fits it.
bool printAll(const std::vector<std::string>& scenes) {
  bool complete = true;
  printHead();
  for (const std::string& name : scenes) {
    const std::optional<ImageFile> file = readReference(load(name));
    const bool usable = file && !file->image.variance.empty();
    complete = complete && usable;
    if (usable) {
      printRow(name, *file);
    } else {
      fmt::print("{:<20} has no reference that fits it\n", name);
    }
  }
  return complete;
}

int reference(ReferenceArguments& arguments) {
  refuseUnequalReplicates(arguments.raysPerPixel, arguments.replicates);
  findSampler(arguments.sampler);
  if (arguments.scenes.empty()) arguments.scenes = shippedSceneNames();
  refuseUnknownScenes(arguments.scenes);
  if (!arguments.check) {
    if (const int code = makeAll(arguments); code != kSuccess) return code;
  }
  if (printAll(arguments.scenes)) return kSuccess;
  fmt::print(stderr, "./pathmark reference makes what is missing.\n");
  return kUsageFault;
}

}  // namespace

void addReferenceCommand(CLI::App& app, CommandAction& action) {
  const auto arguments = std::make_shared<ReferenceArguments>();
  CLI::App* command = app.add_subcommand(
      "reference", "Make the reference images of the shipped scenes, with their own error");
  command->add_option("SCENE", arguments->scenes, "Names of shipped scenes (default: all)")
      ->type_name("");
  takesWholeNumber(command->add_option("--rays-per-pixel", arguments->raysPerPixel,
                                       "Rays through each pixel (default: 1024)"),
                   2, kMostRaysPerPixel);
  takesWholeNumber(command->add_option("--replicates", arguments->replicates,
                                       "Independent parts that the error is measured between "
                                       "(default: 16)"),
                   2, 1024);
  addSamplerOption(*command, arguments->sampler);
  command->add_flag("--check", arguments->check,
                    "Make nothing; say which references there are and how good they are");
  command->add_flag("--again", arguments->again, "Make also those that are there already");
  command->footer(
      "Examples:\n"
      "  ./pathmark reference\n"
      "  ./pathmark reference --check\n"
      "  ./pathmark reference cornell_box --rays-per-pixel 16384\n\n"
      "With the solutions' tracePathMIS. References are in scenes/references; those that fit their "
      "scene and "
      "have\n"
      "as many rays are kept. An interrupted run is gone on with by the same command. The table\n"
      "says, of each, the standard error of the image's mean and the root mean square of the\n"
      "pixels' relative errors.");
  command->callback(
      [arguments, &action] { action = [arguments] { return reference(*arguments); }; });
}

}  // namespace pathmark
