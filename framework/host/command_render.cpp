// pathmark render: one picture of one scene.
#include "film/image_file.h"
#include "host/commands.h"
#include "host/exit_code.h"
#include "host/options.h"
#include "host/session.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <array>
#include <charconv>
#include <cstdio>
#include <limits>
#include <memory>

namespace pathmark {

namespace {

struct RenderArguments {
  std::string scene;
  std::string with = "student";
  std::string size;
  std::string output;
  std::int64_t raysPerPixel = 0;  // 0: the scene's
  int maxBounces = -1;            // -1: the scene's
  RenderOptions options;
};

std::array<int, 2> parseSize(const std::string& text) {
  std::array<int, 2> size{};
  const char *at = text.data(), *end = text.data() + text.size();
  const auto width = std::from_chars(at, end, size[0]);
  const bool separated = width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x';
  const auto height = std::from_chars(separated ? width.ptr + 1 : end, end, size[1]);
  if (!separated || height.ec != std::errc{} || height.ptr != end)
    throw UsageError(
        fmt::format("--size {}: the size is width x height in pixels, such as 640x480.", text));
  return size;
}

// A film pixel takes 32 bytes.
void refuseLargeImages(const LoadedScene& scene) {
  constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 26;
  const FlatCamera& camera = scene.flat.camera;
  if (std::uint64_t{camera.width} * camera.height > kMostPixels)
    throw UsageError(fmt::format("A size of {}x{} has more than {} pixels, which is the most.",
                                 camera.width, camera.height, kMostPixels));
}

// What can be known before the work begins must not cost a picture afterwards.
void refuseOutput(const std::filesystem::path& output) {
  std::string why;
  if (!imageFormatKnown(output, why)) throw UsageError(why);
  if (std::filesystem::is_directory(output))
    throw UsageError(
        fmt::format("--output {}: this is a folder, and a file is needed.", output.string()));
  const std::filesystem::path folder =
      output.has_parent_path() ? output.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder))
    throw UsageError(
        fmt::format("--output {}: there is no folder {}.", output.string(), folder.string()));
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

// Part 0 stands alone, and the other parts do without it.
std::vector<FunctionContract> missingFor(bool warmUp, const StubReport& stubs) {
  std::vector<FunctionContract> missing;
  for (const FunctionContract& f : stubs.unwritten)
    if ((f.part == 0) == warmUp) missing.push_back(f);
  return missing;
}

int render(RenderArguments& arguments) {
  SceneOverrides overrides;
  if (!arguments.size.empty()) overrides.size = parseSize(arguments.size);
  if (arguments.maxBounces >= 0) overrides.maxBounces = arguments.maxBounces;
  const LoadedScene scene = loadScene(findScene(arguments.scene), overrides);
  for (const std::string& note : scene.notes) fmt::print(stderr, "{}\n", note);
  arguments.options.raysPerPixel = static_cast<std::uint64_t>(
      arguments.raysPerPixel > 0 ? arguments.raysPerPixel : scene.raysPerPixel);
  refuseLargeImages(scene);
  if (!arguments.output.empty()) refuseOutput(arguments.output);
  if (arguments.options.warmUp) noteSpheres(scene);

  const Coursework coursework = prepareCoursework(arguments.with);
  const std::string output = !arguments.output.empty()
                                 ? arguments.output
                                 : fmt::format("{}_{}.png", scene.name, coursework.name);
  const RenderOutcome outcome = renderScene(coursework, scene, arguments.options);
  const RenderedImage& rendered = outcome.rendered;
  writeImage(output, rendered.image, scene.exposure);

  const std::string raysMade =
      fmt::format("{:.{}f}", rendered.raysPerPixel, rendered.complete ? 0 : 1);
  fmt::print("{}: {}x{}, {} rays per pixel, {:.2f} s, {:.1f} Mrays/s, with {}\n", output,
             rendered.image.width, rendered.image.height, raysMade, rendered.seconds,
             static_cast<double>(rendered.raysTraced) / rendered.seconds * 1e-6, coursework.name);
  const std::vector<FunctionContract> missing = missingFor(arguments.options.warmUp, outcome.stubs);
  if (!missing.empty()) fmt::print("Not written yet: {}.\n", listOfNames(missing));
  if (const std::string sentence = invalidSentence(rendered, arguments.options.warmUp);
      !sentence.empty()) {
    fmt::print(stderr, "{}\n", sentence);
    return kCourseworkFault;
  }
  if (!rendered.complete) {
    fmt::print(stderr, "Interrupted: the picture has {} of {} rays per pixel.\n", raysMade,
               arguments.options.raysPerPixel);
    return kInterrupted;
  }
  return kSuccess;
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
  command
      ->add_option("--with", arguments->with,
                   "Coursework: student (default), solutions, or a folder of part*.cpp files")
      ->type_name("DIR");
  takesWholeNumber(command->add_option("--rays-per-pixel", arguments->raysPerPixel,
                                       "Rays through each pixel (default: the scene's)"),
                   1, 1000000000);
  command->add_option("--size", arguments->size, "Width x height, such as 640x480")
      ->type_name("WxH");
  takesWholeNumber(
      command->add_option("--max-bounces", arguments->maxBounces,
                          "Scattering events on a path: 1 is direct light, 8 is direct light and "
                          "seven bounces (default: the scene's)"),
      0, 1000);
  takesWholeNumber(command->add_option("--threads", arguments->options.threads,
                                       "Render threads (default: one for each processor)"),
                   1, kMaxThreads);
  takesWholeNumber(command->add_option("--seed", arguments->options.seed,
                                       "Seed of the random numbers (default: 0)"),
                   0, std::numeric_limits<std::int64_t>::max());
  command
      ->add_option("--output", arguments->output,
                   "The file to write: .png to look at; .exr, which also keeps how it was made, .pfm "
                   "or .hdr to compute with (default: SCENE_COURSEWORK.png)")
      ->type_name("FILE");
  command
      ->add_option("--stop-after", arguments->options.secondsWithoutAnswer,
                   "Stop coursework that gives no answer for this many seconds (default: 10)")
      ->check(CLI::Range(0.1, 86400.0))
      ->type_name("SECONDS");
  command->add_flag("--warm-up", arguments->options.warmUp,
                    "Render with part 0's get_ray_radiance; spheres are left out");
  command->footer(
      "Examples:\n"
      "  ./pathmark render ucl_rectangle\n"
      "  ./pathmark render cornell_box --with solutions --rays-per-pixel 256\n"
      "  ./pathmark render cornell_box --warm-up --size 128x128\n"
      "  ./pathmark render student/scenes/my_scene.json --output my_scene.exr\n\n"
      "The same seed gives the same bits, for any number of threads.\n"
      "Exit code: 0 done, 1 the coursework is at fault, 2 the command line or the scene is,\n"
      "3 the machine is, 130 interrupted.");
  command->callback([arguments, &action] { action = [arguments] { return render(*arguments); }; });
}

}  // namespace pathmark
