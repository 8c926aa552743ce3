// pathmark bench lights: what other ways to find the lights buy: multiple importance sampling,
// points on lights by the solid angle, several paths for each camera ray, and paths that pixels
// share.
#include "bench/bench_commands.h"
#include "bench/interrupted_run.h"
#include "bench/machine.h"
#include "bench/picture_folder.h"
#include "bench/progress.h"
#include "bench/render_runs.h"
#include "bench/report.h"
#include "bench/report_file.h"
#include "bench/with_option.h"
#include "host/exit_code.h"
#include "host/options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace pathmark::bench {

namespace {

struct BenchLightsArguments {
  std::vector<std::string> scenes{"veach_plates", "cornell_phong", "cornell_box", "many_lights"};
  std::string with = solvedCoursework();
  std::string json;
  std::int64_t raysPerPixel = 64, seeds = 4;
};

struct Way {
  std::string name;
  std::vector<std::string> options;  // of render
};

const std::vector<Way>& ways() {
  static const std::vector<Way> kWays{
      {"tracePath", {}},
      {"tracePath, solid angle", {"--solid-angle"}},
      {"tracePathMIS", {"--mis"}},
      {"tracePathMIS, solid angle", {"--mis", "--solid-angle"}},
      {"4 paths a ray", {"--split", "4"}},
      {"4 paths a ray, direct light shared", {"--split", "4", "--share-direct"}},
      {"4 pixels share paths", {"--reuse", "4"}},
      {"32 pixels share paths", {"--reuse", "32"}},
      {"16 pixels share paths, 4 for direct light", {"--reuse", "16", "--direct-paths", "4"}}};
  return kWays;
}

std::size_t longestName() {
  std::size_t longest = 0;
  for (const Way& way : ways()) longest = std::max(longest, way.name.size());
  return longest;
}

struct Measured {
  std::vector<double> relativeMse, cpu;

  Mean efficiency() const { return inverseOfProduct(meanOf(relativeMse), meanOf(cpu)); }
};

std::vector<Measured> measure(const RenderRuns& runs, const BenchScene& scene,
                              const BenchLightsArguments& arguments, Progress& progress) {
  std::vector<Measured> all(ways().size());
  for (std::int64_t seed = 1; seed <= arguments.seeds; ++seed)
    for (std::size_t k = 0; k < all.size(); ++k) {
      progress.show(fmt::format("{}, {}", scene.name, ways()[k].name));
      const RunResult run =
          runs.render({.scene = scene.name,
                       .raysPerPixel = static_cast<std::uint64_t>(arguments.raysPerPixel),
                       .seed = static_cast<std::uint64_t>(seed),
                       .options = ways()[k].options});
      all[k].relativeMse.push_back(deviationOf(run.image, scene.reference).relativeMse);
      all[k].cpu.push_back(run.usage.cpuSeconds);
      progress.advance(1.0);
    }
  return all;
}

void addRows(Table& table, const BenchScene& scene, const std::vector<Measured>& all) {
  const Mean first = all[0].efficiency();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Mean mse = meanOf(all[k].relativeMse), efficiency = all[k].efficiency();
    const double ratio = efficiency.value / first.value;
    const double error = ratio * std::hypot(efficiency.error / efficiency.value,
                                            k == 0 ? 0.0 : first.error / first.value);
    table.add({scene.name, ways()[k].name, 1e4 * mse.value, 1e4 * mse.error,
               meanOf(all[k].cpu).value, ratio, k == 0 ? Cell() : Cell(error)});
  }
}

int benchLights(const BenchLightsArguments& arguments) {
  refuseJsonFile(arguments.json);
  std::vector<BenchScene> scenes;
  for (const std::string& name : arguments.scenes) scenes.push_back(loadBenchScene(name, name));
  const PictureFolder folder("");
  const RenderRuns runs(prepareCoursework(arguments.with), folder.path());
  Progress progress("bench lights",
                    static_cast<double>(scenes.size() * ways().size()) * double(arguments.seeds));
  Table table{"lights",
              fmt::format("Finding lights: {} rays per pixel, {} seeds, one thread",
                          arguments.raysPerPixel, arguments.seeds),
              {{"scene", "scene"},
               {"way", "way", 0, longestName()},
               {"relMse", "relMSE x 1e4", 3},
               {"relMseError", "+-", 3},
               {"cpuSeconds", "CPU s", 2},
               {"efficiencyRatio", "efficiency / tracePath's", 2},
               {"efficiencyRatioError", "+-", 2}},
              {}};
  try {
    for (const BenchScene& scene : scenes) {
      const std::vector<Measured> all = measure(runs, scene, arguments, progress);
      progress.clear();
      if (table.rows.empty()) table.printHead();
      addRows(table, scene, all);
    }
  } catch (const Interrupted&) {
    progress.clear();
    fmt::print(stderr, "Interrupted: no JSON was written.\n");
    return kInterrupted;
  }
  const Report report{.command = "bench lights",
                      .machine = machineLine(),
                      .tables = {std::move(table)},
                      .figures = {}};
  printFigures(report);
  writeJson(arguments.json, report);
  return kSuccess;
}

}  // namespace

void addBenchLightsCommand(CLI::App& bench, CommandAction& action) {
  const auto arguments = std::make_shared<BenchLightsArguments>();
  CLI::App* command = bench.add_subcommand(
      "lights",
      "What bonus parts 8 and 9 and shared paths buy: error and time with and without them");
  command
      ->add_option("SCENE", arguments->scenes,
                   "Scenes that have a reference (default: veach_plates, cornell_phong, "
                   "cornell_box and many_lights)")
      ->type_name("");
  addWithOption(*command, arguments->with);
  takesWholeNumber(command->add_option("--rays-per-pixel", arguments->raysPerPixel,
                                       "Rays through each pixel (default: 64)"),
                   1, 1000000);
  takesWholeNumber(command->add_option("--seeds", arguments->seeds,
                                       "Renders of each kind, in turns, whose differences give the "
                                       "error (default: 4)"),
                   2, 1000);
  addJsonOption(*command, arguments->json);
  command->footer(
      "Examples:\n"
      "  ./pathmark bench lights\n"
      "  ./pathmark bench lights veach_plates --seeds 8 --json lights.json\n\n"
      "Efficiency is 1 / (relative mean squared error x CPU seconds of the whole process), of\n"
      "processes of one thread. All ways take turns, so that other programs disturb them "
      "alike.");
  command->callback(
      [arguments, &action] { action = [arguments] { return benchLights(*arguments); }; });
}

}  // namespace pathmark::bench
