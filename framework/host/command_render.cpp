// pathmark render: one picture of one scene.
#include "film/image_file.h"
#include "host/adaptive_picture.h"
#include "host/commands.h"
#include "host/exit_code.h"
#include "host/explain_render.h"
#include "host/options.h"
#include "host/output_check.h"
#include "host/output_file.h"
#include "host/render_picture.h"
#include "host/size_option.h"
#include "scene/limits.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace pathmark {

namespace {

constexpr std::int64_t kMostRaysForTarget = 16384;

struct RenderArguments {
  std::string scene;
  std::string with = "student";
  std::string size;
  std::string sampler = "sobol";
  std::optional<std::string> paths;
  std::string output;             // empty: by the scene and the coursework
  std::int64_t raysPerPixel = 0;  // 0: the scene's
  int maxBounces = -1;            // -1: the scene's
  int split = 1;                  // paths for each camera ray
  int reuse = 1;                  // pixels that share their paths
  int directPaths = 1;            // for the direct light of each of their camera rays
  bool explain = false, warmUp = false, mis = false, solidAngle = false, shareDirect = false;
  std::string targetError, rayMap;        // empty: none
  std::optional<double> checkpointEvery;  // seconds
  PictureRequest picture;
};

// A film pixel takes 32 bytes.
void refuseLargeImages(const LoadedScene& scene) {
  const FlatCamera& camera = scene.flat.camera;
  if (std::uint64_t{camera.width} * camera.height > kMostPixels)
    throw UsageError(fmt::format("A size of {}x{} has more than {} pixels, which is the most.",
                                 camera.width, camera.height, kMostPixels));
}

void noteSpheres(const LoadedScene& scene) {
  if (scene.flat.spheres.empty()) return;
  const bool onlySpheresShine = scene.flat.faces.empty();
  fmt::print(stderr, "The warm-up knows triangles only: {} left out{}.\n",
             scene.flat.spheres.size() == 1
                 ? "one sphere is"
                 : fmt::format("{} spheres are", scene.flat.spheres.size()),
             onlySpheresShine ? ", and with them all light" : "");
}

void noteVariance(const std::filesystem::path& output, const RenderOptions& options) {
  if (options.replicates > 1 && imageEnding(output) != ".exr")
    fmt::print(stderr,
               "{} will not have the variance between the replicates: only .exr files do.\n",
               output.string());
}

// What cannot be had together with --target-error.
void refuseWithTargetError(const RenderArguments& arguments) {
  const auto refuse = [](const char* option, const char* why) {
    throw UsageError(fmt::format("--target-error and {} do not go together: {}.", option, why));
  };
  if (arguments.picture.options.replicates > 1)
    refuse("--replicates", "the picture is made in four groups anyway, which tell its variance");
  if (arguments.picture.checkpoints.resume || arguments.picture.checkpoints.keep)
    refuse(arguments.picture.checkpoints.resume ? "--resume" : "--keep-checkpoint",
           "such a render keeps no checkpoint, since how many rays are needed is decided anew");
  if (arguments.checkpointEvery.value_or(0.0) > 0.0)
    refuse("--checkpoint-every", "such a render keeps no checkpoint");
}

void refuseRayMap(const RenderArguments& arguments, std::uint64_t pixels) {
  if (sameFile(arguments.rayMap, arguments.output))
    throw UsageError(
        fmt::format("--ray-map {}: this is the picture's own file.", arguments.rayMap));
  refuseOutput(arguments.rayMap, pixels);
}

int renderToStatedError(const RenderArguments& arguments, const LoadedScene& scene) {
  const double error = parseTargetError(arguments.targetError);
  const std::uint64_t pixels = settingsFor(scene, arguments.picture.options).pixels();
  if (!arguments.rayMap.empty()) refuseRayMap(arguments, pixels);
  return renderToTarget(prepareCoursework(arguments.with), scene,
                        {arguments.output, arguments.picture.options, error, arguments.rayMap});
}

// What only some paths that are shared can have.
void refuseWithoutSharing(const RenderArguments& arguments) {
  if (arguments.shareDirect && arguments.split == 1)
    throw UsageError(
        "--share-direct: found --split 1, but only paths of one camera ray share their direct "
        "light, from --split 2 on.");
  if (arguments.directPaths > 1 && arguments.reuse == 1)
    throw UsageError(fmt::format(
        "--direct-paths {}: found --reuse 1, but only pixels that share their paths have some for "
        "the direct light, from --reuse 2 on.",
        arguments.directPaths));
}

void sharePaths(const RenderArguments& arguments, RenderOptions& options) {
  if (arguments.split > 1) {
    options.estimator = Estimator::kSplit;
    options.sharing.pathsPerRay = static_cast<std::uint32_t>(arguments.split);
    options.sharing.directLight = arguments.shareDirect ? 1 : 0;
  }
  if (arguments.reuse > 1) {
    options.estimator = Estimator::kReuse;
    options.sharing.pixels = static_cast<std::uint32_t>(arguments.reuse);
    options.sharing.directPaths = static_cast<std::uint32_t>(arguments.directPaths);
  }
}

int render(RenderArguments& arguments) {
  if (arguments.warmUp && arguments.paths)
    throw UsageError(
        "--paths and --warm-up: the warm-up finds its light by itself, so that nothing can be kept "
        "out of it; --paths goes with part 5.");
  if (!arguments.targetError.empty()) {
    parseTargetError(arguments.targetError);
    refuseWithTargetError(arguments);
  } else if (!arguments.rayMap.empty()) {
    throw UsageError(
        "--ray-map is for pictures with a --target-error: others have the same number "
        "of rays everywhere.");
  }
  if (arguments.mis && arguments.paths)
    throw UsageError("--mis and --paths: light paths are told apart only in what tracePath finds.");
  if (arguments.reuse > 1 && arguments.paths)
    throw UsageError(
        "--reuse and --paths: light paths are told apart only within one path, and --reuse "
        "connects the surfaces of two.");
  refuseWithoutSharing(arguments);
  SceneOverrides overrides;
  if (!arguments.size.empty()) overrides.size = parseSize(arguments.size);
  if (arguments.maxBounces >= 0) overrides.maxBounces = arguments.maxBounces;
  LoadedScene scene = loadScene(findScene(arguments.scene), overrides);
  if (arguments.solidAngle) scene.flat.lightSampling = LightSampling::kBySolidAngle;
  for (const std::string& note : scene.notes) fmt::print(stderr, "{}\n", note);
  if (arguments.checkpointEvery)
    arguments.picture.checkpoints.everySeconds = *arguments.checkpointEvery;
  RenderOptions& options = arguments.picture.options;
  options.raysPerPixel =
      static_cast<std::uint64_t>(arguments.raysPerPixel > 0      ? arguments.raysPerPixel
                                 : arguments.targetError.empty() ? scene.raysPerPixel
                                                                 : kMostRaysForTarget);
  if (!arguments.targetError.empty()) refuseFewRays(options.raysPerPixel);
  options.sampler = findSampler(arguments.sampler);
  if (arguments.paths) options.paths = findPaths(*arguments.paths);
  if (arguments.warmUp) options.estimator = Estimator::kWarmUp;
  if (arguments.mis) options.estimator = Estimator::kMis;
  sharePaths(arguments, options);
  refuseLargeImages(scene);
  refuseUnequalReplicates(options.raysPerPixel, options.replicates);
  if (arguments.explain) {
    const RenderSettings settings = settingsFor(scene, options);
    fmt::print("{}", arguments.targetError.empty()
                         ? explainRender(scene, settings)
                         : explainRenderToTarget(scene, settings,
                                                 parseTargetError(arguments.targetError)));
    return kSuccess;
  }
  if (arguments.output.empty())
    arguments.output = fmt::format("{}_{}.png", scene.name, courseworkName(arguments.with));
  arguments.picture.output = arguments.output;
  refuseOutput(arguments.output, settingsFor(scene, options).pixels());
  if (arguments.targetError.empty()) {
    requirePlaceForCheckpoint(arguments.output);
    noteVariance(arguments.output, options);
  }
  if (arguments.warmUp) noteSpheres(scene);
  if (!arguments.targetError.empty()) return renderToStatedError(arguments, scene);
  return renderPicture(prepareCoursework(arguments.with), scene, arguments.picture);
}

void addLongRenderOptions(CLI::App& command, RenderArguments& arguments) {
  CheckpointOptions& checkpoints = arguments.picture.checkpoints;
  takesWholeNumber(
      command.add_option("--replicates", arguments.picture.options.replicates,
                         "Make the rays in so many independent groups, and tell the variance of "
                         "every pixel by their differences; rays per pixel are a multiple of it"),
      2, 1024);
  takesSeconds(
      command.add_option("--checkpoint-every", arguments.checkpointEvery,
                         "Write OUTPUT.checkpoint that often, and on Ctrl-C, until the picture is "
                         "complete (default: 60; 0: never)"),
      0.0, 1e6);
  command.add_flag("--resume", checkpoints.resume,
                   "Go on from OUTPUT.checkpoint, to the same bits as without a break");
  command.add_flag("--keep-checkpoint", checkpoints.keep,
                   "Keep OUTPUT.checkpoint of a complete picture, to refine it with --resume and "
                   "more rays per pixel or replicates; how, is said at the end");
}

void addTargetErrorOptions(CLI::App& command, RenderArguments& arguments) {
  takesText(command.add_option(
                "--target-error", arguments.targetError,
                "Give each tile of 16x16 pixels as many rays as its error needs to be below this, "
                "such as 1%: the root of its pixels' mean variance, relative to its brightness, "
                "or to a tenth of the picture's where it is darker; --rays-per-pixel is then the "
                "most (default: 16384), and no checkpoint is kept: not with --replicates, "
                "--resume, --keep-checkpoint or --checkpoint-every"),
            "ERROR", "a share such as 1%");
  takesText(
      command.add_option(
          "--ray-map", arguments.rayMap,
          "With --target-error, also write how many rays each tile got: .png to look at, .exr or "
          ".pfm for numbers"),
      "FILE", "the name of a file");
}

std::string isPowerOfTwo(const std::string& text) {
  return std::has_single_bit(std::strtoul(text.c_str(), nullptr, 10))
             ? ""
             : "found " + text + ", allowed is 1, 2, 4, 8, 16, 32 or 64";
}

// Ways of tracing paths that tracePath itself knows nothing of.
void addSharingOptions(CLI::App& command, RenderArguments& arguments,
                       const std::vector<CLI::Option*>& otherEstimators) {
  CLI::Option* const split =
      command.add_option("--split", arguments.split,
                         "Trace so many paths for each camera ray, which share the surface that "
                         "it meets first (default: 1)");
  takesWholeNumber(split, 1, PathSharing::kMost);
  command
      .add_flag("--share-direct", arguments.shareDirect,
                "Let those paths share the direct light there, too, where the noise is from the "
                "indirect")
      ->needs(split);
  CLI::Option* const reuse =
      command.add_option("--reuse", arguments.reuse,
                         "Let the paths of so many neighbouring pixels serve all of them: 2, 4, 8, "
                         "16, 32 or 64 (default: 1)");
  takesWholeNumber(reuse, 1, PathSharing::kMost);
  reuse->check(isPowerOfTwo);
  CLI::Option* const directPaths =
      command.add_option("--direct-paths", arguments.directPaths,
                         "Trace so many paths for the direct light of each camera ray, where the "
                         "noise of --reuse is from that (default: 1)");
  takesWholeNumber(directPaths->needs(reuse), 1, PathSharing::kMost);
  reuse->excludes(split);
  for (CLI::Option* const other : otherEstimators) {
    split->excludes(other);
    reuse->excludes(other);
  }
}

}  // namespace

void addRenderCommand(CLI::App& app, CommandAction& action) {
  const auto arguments = std::make_shared<RenderArguments>();
  CLI::App* command = app.add_subcommand("render", "Render a scene to a picture");
  command
      ->add_option("SCENE", arguments->scene,
                   "A scene's name in scenes/ or student/scenes/, or a .json file")
      ->required()
      ->type_name("");
  command->add_option("--with", arguments->with, "Coursework: " + courseworkChoices("student"))
      ->type_name("DIR");
  takesWholeNumber(command->add_option("--rays-per-pixel", arguments->raysPerPixel,
                                       "Rays through each pixel (default: the scene's)"),
                   1, kMostRaysPerPixel);
  takesText(command->add_option("--size", arguments->size, "Width x height, such as 640x480"),
            "WxH", "a width and a height such as 640x480");
  takesWholeNumber(
      command->add_option("--max-bounces", arguments->maxBounces,
                          "Scattering events on a path: 1 is direct light, 8 is direct light and "
                          "seven bounces (default: the scene's)"),
      0, 1000);
  takesWholeNumber(command->add_option("--threads", arguments->picture.options.threads,
                                       "Render threads (default: one for each processor)"),
                   1, kMaxThreads);
  takesWholeNumber(command->add_option("--seed", arguments->picture.options.seed,
                                       "Seed of the random numbers (default: 0)"),
                   0, std::numeric_limits<std::int64_t>::max());
  addSamplerOption(*command, arguments->sampler);
  takesText(command->add_option(
                "--output", arguments->output,
                "The file to write: .png to look at; .exr, which also keeps how it was made, .pfm "
                "or .hdr to compute with (default: SCENE_COURSEWORK.png)"),
            "FILE", "the name of a file");
  takesSeconds(command->add_option(
                   "--stop-after", arguments->picture.options.secondsWithoutAnswer,
                   "Stop coursework that gives no answer for this many seconds (default: 10)"),
               0.1, 86400.0);
  CLI::Option* const warmUp =
      command->add_flag("--warm-up", arguments->warmUp,
                        "Render with part 0's get_ray_radiance; spheres are left out");
  CLI::Option* const mis =
      command
          ->add_flag("--mis", arguments->mis,
                     "Render with bonus part 8's tracePathMIS in place of tracePath")
          ->excludes(warmUp);
  addSharingOptions(*command, *arguments, {warmUp, mis});
  command
      ->add_flag("--solid-angle", arguments->solidAngle,
                 "Sample lights that are one triangle or rectangle by bonus part 9, by the solid "
                 "angle that they fill")
      ->excludes(warmUp);
  addPathsOption(*command, arguments->paths, "; not with --warm-up, --mis or --reuse");
  addLongRenderOptions(*command, *arguments);
  addTargetErrorOptions(*command, *arguments);
  command->add_flag("--explain", arguments->explain,
                    "Print how rays would be answered in the scene, and why, and render nothing");
  command->footer(
      "Examples:\n"
      "  ./pathmark render ucl_rectangle\n"
      "  ./pathmark render cornell_box --rays-per-pixel 256\n"
      "  ./pathmark render cornell_box --warm-up --size 128x128\n"
      "  ./pathmark render veach_plates --mis\n"
      "  ./pathmark render blob --split 4\n"
      "  ./pathmark render cornell_box --reuse 16\n"
      "  ./pathmark render cornell_box --explain\n"
      "  ./pathmark render cornell_phong --paths 'LS+DE' --output caustic.png\n"
      "  ./pathmark render student/scenes/my_scene.json --output my_scene.exr\n"
      "  ./pathmark render cornell_box --rays-per-pixel 100000 --output box.png   (Ctrl-C)\n"
      "  ./pathmark render cornell_box --rays-per-pixel 100000 --output box.png --resume\n"
      "  ./pathmark render cornell_box --rays-per-pixel 1024 --replicates 16\n"
      "  ./pathmark render cornell_box --target-error 2% --ray-map rays.png\n\n"
      "The same seed gives the same bits, for any number of threads and breaks. A checkpoint of "
      "an\n"
      "older render is never lost: without --resume it is replaced only by one that has all of "
      "its\n"
      "rays, or else renamed to OUTPUT.checkpoint.old.\n"
      "Exit code: 0 done, 1 the coursework is at fault, 2 the command line or the scene is,\n"
      "3 the machine is, 130 interrupted.");
  command->callback([arguments, &action] { action = [arguments] { return render(*arguments); }; });
}

}  // namespace pathmark
