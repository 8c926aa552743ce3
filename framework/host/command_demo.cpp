// pathmark demo: the main job on real input, and a table of what it did.
#include "film/image_file.h"
#include "host/build_config.h"
#include "host/commands.h"
#include "host/display_path.h"
#include "host/exit_code.h"
#include "host/options.h"
#include "host/session.h"
#include "scene/limits.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

constexpr const char* kScenes[] = {"ucl_rectangle", "cornell_box"};

// Without those of bonus parts, as status counts them.
std::ptrdiff_t countAsked(std::span<const FunctionContract> functions) {
  return std::count_if(functions.begin(), functions.end(),
                       [](const FunctionContract& f) { return !isBonus(f); });
}

int renderAndPrint(const Coursework& coursework, const std::string& name, std::uint64_t rays,
                   const fs::path& folder) {
  const LoadedScene scene = loadScene(findScene(name));
  RenderOptions options;
  options.raysPerPixel = rays;
  const RenderOutcome outcome = renderScene(coursework, scene, options);
  const RenderedImage& rendered = outcome.rendered;
  const fs::path file = folder / fmt::format("{}_{}.png", name, coursework.name);
  writeImage(file, rendered.image, scene.exposure);
  fmt::print("{:<14} {:<10} {:>14} {:>8.2f} {:>8.1f}   {}\n", name, coursework.name,
             rendered.raysPerPixel, rendered.seconds,
             static_cast<double>(rendered.raysTraced) / rendered.seconds * 1e-6,
             fmt::format("{} of {}", countAsked(outcome.stubs.unwritten), countAsked(contract())));
  std::fflush(stdout);
  if (const std::string sentence = invalidSentence(rendered, Estimator::kPath); !sentence.empty()) {
    fmt::print(stderr, "{}\n", sentence);
    return kCourseworkFault;
  }
  return rendered.complete ? kSuccess : kInterrupted;
}

// One coursework's rows. A coursework that fails costs its own rows only.
int demoCoursework(const std::string& with, std::uint64_t rays, const fs::path& folder) {
  try {
    const Coursework coursework = prepareCoursework(with);
    int code = kSuccess;
    for (const char* scene : kScenes) {
      code = std::max(code, renderAndPrint(coursework, scene, rays, folder));
      if (code == kInterrupted) break;
    }
    return code;
  } catch (const CourseworkError& e) {
    fmt::print(stderr, "{}\n", e.what());
  } catch (const WorkerError& e) {
    fmt::print(stderr, "{}\n", e.what());
  }
  return kCourseworkFault;
}

int demo(std::uint64_t rays) {
  const fs::path folder = fs::path(build::kBuildFolder) / "pictures";
  fs::create_directories(folder);
  fmt::print("{:<14} {:<10} {:>14} {:>8} {:>8}   {}\n", "scene", "coursework", "rays per pixel",
             "seconds", "Mrays/s", "stubs not yet written");
  std::fflush(stdout);
  int code = kSuccess;
  for (const char* with : {"student", "solutions"}) {
    if (!fs::exists(fs::path(build::kProjectFolder) / with)) continue;
    code = std::max(code, demoCoursework(with, rays, folder));
    if (code == kInterrupted) return code;
  }
  fmt::print("\nThe pictures are in {}\n", displayPath(folder));
  if (code == kSuccess)
    fmt::print(
        "Next: ./pathmark check says what is written, what is right, and what comes next.\n");
  return code;
}

}  // namespace

void addDemoCommand(CLI::App& app, CommandAction& action) {
  const auto rays = std::make_shared<std::uint64_t>(64);
  CLI::App* command =
      app.add_subcommand("demo", "Install what is missing, build, and render two scenes");
  takesWholeNumber(
      command->add_option("--rays-per-pixel", *rays, "Rays through each pixel (default: 64)"), 1,
      kMostRaysPerPixel);
  command->footer(
      "Examples:\n"
      "  ./pathmark demo\n"
      "  ./pathmark demo --yes                    (install missing packages without asking)\n"
      "  ./pathmark demo --rays-per-pixel 256");
  command->callback([rays, &action] { action = [rays] { return demo(*rays); }; });
}

}  // namespace pathmark
