// pathmark preview: the window.
#include "host/commands.h"
#include "host/exit_code.h"
#include "host/options.h"
#include "host/output_file.h"
#include "host/session.h"
#include "preview/app.h"
#include "preview/remembered.h"
#include "scene/limits.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <thread>

namespace pathmark {

namespace {

struct PreviewArguments {
  std::string scene;
  std::string sampler = "sobol";
  std::optional<std::string> paths;
  std::string size;
  std::string tab = "progress";
  std::string pick;
  std::string screenshot, picture;
  std::int64_t rays = 0;
  std::uint32_t threads = 0;
  double scale = 0.0;
  preview::AppOptions app;
};

// Two whole numbers with something between them.
std::pair<int, int> twoNumbers(const std::string& option, const std::string& text, char between,
                               const char* example) {
  std::pair<int, int> numbers{};
  const char *at = text.data(), *end = text.data() + text.size();
  const auto first = std::from_chars(at, end, numbers.first);
  const bool separated = first.ec == std::errc{} && first.ptr != end && *first.ptr == between;
  const auto second = std::from_chars(separated ? first.ptr + 1 : end, end, numbers.second);
  if (!separated || second.ec != std::errc{} || second.ptr != end || numbers.first < 0 ||
      numbers.second < 0)
    throw UsageError(
        fmt::format("{} {}: it is two whole numbers, such as {}.", option, text, example));
  return numbers;
}

preview::Tab findTab(const std::string& name) {
  for (int k = 0; k < preview::kTabs; ++k)
    if (name == preview::kTabNames[k]) return static_cast<preview::Tab>(k);
  throw UsageError(
      fmt::format("--tab {}: it is one of {}.", name, fmt::join(preview::kTabNames, ", ")));
}

// What is remembered is as large as the window was on the screen, its scale included.
preview::WindowOptions windowOptions(const PreviewArguments& arguments,
                                     const preview::Remembered& last) {
  preview::WindowOptions options{.title = "Pathmark", .scale = arguments.scale};
  if (!arguments.size.empty()) {
    const auto [width, height] = twoNumbers("--size", arguments.size, 'x', "1280x800");
    options.width = std::clamp(width, 320, 16384);
    options.height = std::clamp(height, 240, 16384);
  } else if (last.width && last.height) {
    options.width = *last.width;
    options.height = *last.height;
    options.enlarged = false;
  }
  return options;
}

std::filesystem::path sceneFile(const std::string& scene, const preview::Remembered& last) {
  if (!scene.empty()) return findScene(scene);
  if (last.scene && std::filesystem::is_regular_file(*last.scene)) return *last.scene;
  return findScene("cornell_box");
}

void readArguments(PreviewArguments& arguments, const preview::Remembered& last) {
  preview::AppOptions& app = arguments.app;
  app.request.scene = sceneFile(arguments.scene, last);
  findCoursework(app.request.with);
  app.request.sampler = findSampler(arguments.sampler);
  if (arguments.paths) app.request.paths = findPaths(*arguments.paths);
  app.request.threads = arguments.threads != 0 ? arguments.threads
                                               : std::max(1u, std::thread::hardware_concurrency());
  if (arguments.rays > 0) app.request.mostRays = static_cast<double>(arguments.rays);
  if (app.part < 0 && last.part) app.part = *last.part;
  app.tab = findTab(arguments.tab);
  if (!arguments.pick.empty()) app.pick = twoNumbers("--pick", arguments.pick, ',', "128,90");
  app.screenshot = arguments.screenshot;
  app.picture = arguments.picture;
  if (app.scripted() && arguments.rays == 0)
    throw UsageError(
        "--screenshot and --picture need --after-rays N, the rays per pixel to wait for.");
  if (!app.screenshot.empty()) requireOutput("--screenshot", app.screenshot, {".png"});
  if (!app.picture.empty())
    requireOutput("--picture", app.picture, {".png", ".exr", ".pfm", ".hdr"});
}

// A script shows the same whatever somebody has looked at before, and leaves no trace.
int openPreview(PreviewArguments& arguments) {
  const bool scripted = !arguments.screenshot.empty() || !arguments.picture.empty();
  const std::filesystem::path memory =
      scripted ? std::filesystem::path() : preview::rememberedFile();
  const preview::Remembered last = preview::readRemembered(memory);
  readArguments(arguments, last);
  preview::Window window(windowOptions(arguments, last));
  preview::App app(window, arguments.app);
  const int code = app.run();
  preview::writeRemembered(memory, app.remembered());
  return code;
}

}  // namespace

void addPreviewCommand(CLI::App& app, CommandAction& action) {
  const auto arguments = std::make_shared<PreviewArguments>();
  CLI::App* command = app.add_subcommand(
      "preview", "Open a window that shows the picture, and renders it anew after each save");
  command
      ->add_option("SCENE", arguments->scene,
                   "A scene's name in scenes/ or student/scenes/, or a .json file (default: the "
                   "last one, or cornell_box)")
      ->type_name("");
  command
      ->add_option("--with", arguments->app.request.with,
                   "Coursework: " + courseworkChoices("student"))
      ->type_name("DIR");
  takesWholeNumber(command
                       ->add_option("--part", arguments->app.part,
                                    "The part to begin with, whose functions make the picture: 0 "
                                    "the warm-up, 8 tracePathMIS, 9 lights by the solid angle, "
                                    "others tracePath")
                       ->check([](const std::string& text) -> std::string {
                         if (text != "7") return {};
                         return "found 7, which has scenes and no functions; allowed is 0 to 6, 8 "
                                "or 9";
                       }),
                   0, 9);
  addSamplerOption(*command, arguments->sampler);
  addPathsOption(*command, arguments->paths);
  takesWholeNumber(command->add_option("--seed", arguments->app.request.seed,
                                       "Seed of the random numbers (default: 0)"),
                   0, std::numeric_limits<std::int64_t>::max());
  takesWholeNumber(command->add_option("--threads", arguments->threads,
                                       "Render threads (default: one for each processor)"),
                   1, kMaxThreads);
  takesSeconds(command->add_option("--stop-after", arguments->app.request.secondsWithoutAnswer,
                                   "Stop coursework that gives no answer for this many seconds "
                                   "(default: 10)"),
               0.1, 86400.0);
  command
      ->add_option("--size", arguments->size,
                   "Of the window (default: as it was last time, or 1280x800)")
      ->type_name("WxH");
  takesNumber(command->add_option("--scale", arguments->scale,
                                  "Of letters and buttons, such as 2 on a high-density screen "
                                  "(default: the screen's own)"),
              0.5, 8.0, "X");
  command
      ->add_option("--tab", arguments->tab,
                   "The panel to begin with: progress, samples, paths, compare or view")
      ->type_name("NAME");
  command->add_option("--pick", arguments->pick, "A pixel whose paths to show: COLUMN,ROW")
      ->type_name("X,Y");
  constexpr double kMostStops = 100.0;
  takesNumber(
      command->add_option("--exposure", arguments->app.exposureStops, "In stops, such as -1"),
      -kMostStops, kMostStops, "STOPS");
  takesWholeNumber(
      command->add_option("--after-rays", arguments->rays, "Stop at so many rays per pixel"), 1,
      kMostRaysPerPixel);
  command
      ->add_option("--screenshot", arguments->screenshot,
                   "Write the window as a PNG file after those rays, and end")
      ->type_name("FILE");
  command
      ->add_option("--picture", arguments->picture,
                   "Write the picture as a .png or .exr file after those rays, and end")
      ->type_name("FILE");
  command->footer(
      "Examples:\n"
      "  ./pathmark preview\n"
      "  ./pathmark preview ucl_rectangle --part 2\n"
      "  ./pathmark preview veach_plates --part 8\n"
      "  ./pathmark preview cornell_phong --paths LS+DE --tab view\n"
      "  ./pathmark preview cornell_box --with path/to/other/coursework\n"
      "  ./pathmark preview student/scenes/my_scene.json --scale 2\n"
      "  ./pathmark preview cornell_box --tab paths --pick 128,90 --after-rays 64 --screenshot "
      "window.png\n"
      "  xvfb-run -a -s \"-screen 0 1280x800x24 -noreset\" ./pathmark preview --after-rays 64 "
      "--screenshot window.png\n"
      "                                        (where there is no display)\n\n"
      "In the window, ? shows the keys; handouts/preview.md explains the rest.\n"
      "Exit code: 0 closed, or the script is done; with --screenshot or --picture 1 if the "
      "coursework\n"
      "is at fault; 2 the command line or the scene is, 3 the machine is: no display, for "
      "example.");
  command->callback(
      [arguments, &action] { action = [arguments] { return openPreview(*arguments); }; });
}

}  // namespace pathmark
