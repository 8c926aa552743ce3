// pathmark bench render: whole renders, against the raw speed of rays and against a peer.
#include "bench/bench_commands.h"
#include "bench/interrupted_run.h"
#include "bench/machine.h"
#include "bench/picture_folder.h"
#include "bench/render_bench.h"
#include "bench/report_file.h"
#include "bench/with_option.h"
#include "host/exit_code.h"
#include "host/options.h"
#include "host/session.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <memory>

namespace pathmark::bench {

namespace {

struct BenchRenderArguments {
  std::vector<std::string> scenes;
  std::string with = solvedCoursework();
  std::string peer;
  std::string json;
  std::string keep;
  std::int64_t seeds = 0;  // 0: the plan's
  bool quick = false;
};

constexpr std::array<std::pair<const char*, const char*>, 3> kScenes{
    {{"s1", "cornell_box"}, {"s2", "cornell_spheres"}, {"s3", "blob"}}};

RenderPlan planFor(const BenchRenderArguments& arguments) {
  RenderPlan plan;
  if (arguments.quick)
    plan = {.fewRays = 4, .manyRays = 16, .seeds = 2, .repeats = 3, .raySeconds = 0.01};
  if (arguments.seeds > 0) plan.seeds = static_cast<int>(arguments.seeds);
  return plan;
}

std::vector<BenchScene> loadScenes(const std::vector<std::string>& wanted) {
  std::vector<BenchScene> scenes;
  for (const auto& [key, name] : kScenes)
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end())
      scenes.push_back(loadBenchScene(key, name));
  return scenes;
}

void refuseUnknown(const BenchRenderArguments& arguments) {
  for (const std::string& name : arguments.scenes)
    if (std::none_of(kScenes.begin(), kScenes.end(),
                     [&](const auto& s) { return s.second == name; }))
      throw UsageError(fmt::format(
          "bench render {}: its scenes are cornell_box, cornell_spheres and blob.", name));
  if (!arguments.peer.empty() && arguments.peer != "cycles")
    throw UsageError(fmt::format("--peer {}: cycles is the only one.", arguments.peer));
}

int render(const BenchRenderArguments& arguments) {
  refuseUnknown(arguments);
  refuseJsonFile(arguments.json);
  const PictureFolder folder(arguments.keep);
  std::optional<CyclesPeer> cycles;
  if (!arguments.peer.empty()) {
    cycles = CyclesPeer::find(folder.path());
    if (!cycles)
      throw UsageError(
          "--peer cycles: there is no program blender; on Debian and Ubuntu it is "
          "the package blender.");
  }
  RenderRuns runs(prepareCoursework(arguments.with), folder.path());
  const RenderPlan plan = planFor(arguments);
  std::vector<BenchScene> scenes = loadScenes(arguments.scenes);
  const double steps = static_cast<double>(scenes.size()) * plan.seeds * (cycles ? 2.0 : 1.0) +
                       2.0 * plan.seeds + static_cast<double>(scenes.size());
  RenderBench bench{
      plan,
      std::move(runs),
      std::move(scenes),
      std::move(cycles),
      Progress("bench render", steps),
      {.command = "bench render", .machine = machineLine(), .tables = {}, .figures = {}}};
  try {
    measureEfficiency(bench);
    measureGrowth(bench);
    measureThreads(bench);
    measureStart(bench);
    measureMemoryUse(bench);
  } catch (const Interrupted&) {
    bench.progress.clear();
    fmt::print(stderr, "Interrupted: no JSON was written.\n");
    return kInterrupted;
  }
  bench.progress.clear();
  printFigures(bench.report);
  writeJson(arguments.json, bench.report);
  return kSuccess;
}

}  // namespace

void addBenchRenderCommand(CLI::App& bench, CommandAction& action) {
  const auto arguments = std::make_shared<BenchRenderArguments>();
  CLI::App* command = bench.add_subcommand(
      "render", "Efficiency, speed, threads, start and memory of whole renders");
  command
      ->add_option("SCENE", arguments->scenes,
                   "cornell_box (s1), cornell_spheres (s2), blob (s3) (default: all three)")
      ->type_name("");
  addWithOption(*command, arguments->with);
  command
      ->add_option("--peer", arguments->peer,
                   "Render the same with another program too: cycles, which needs blender")
      ->type_name("PEER");
  takesWholeNumber(command->add_option("--seeds", arguments->seeds,
                                       "Renders of each scene, whose differences give the error "
                                       "(default: 3)"),
                   2, 1000);
  command->add_flag("--quick", arguments->quick,
                    "With 4 and 16 rays per pixel instead of 64 and 256: whether all of it works");
  command
      ->add_option("--keep", arguments->keep,
                   "Keep the last pictures, the peer's too, in this folder")
      ->type_name("DIR");
  addJsonOption(*command, arguments->json);
  command->footer(
      "Examples:\n"
      "  ./pathmark bench render\n"
      "  ./pathmark bench render --peer cycles --json render.json\n"
      "  ./pathmark bench render cornell_box --seeds 10\n"
      "  ./pathmark bench render cornell_box --quick\n\n"
      "Efficiency is 1 / (relative mean squared error x CPU seconds), of processes of one thread\n"
      "from their start to their end. The error is that against the scene's reference, less the\n"
      "reference's own. Rates are what more rays per pixel cost, in CPU seconds, so that neither\n"
      "the start nor other programs count. The mesh of the blob is made if it is missing.");
  command->callback([arguments, &action] { action = [arguments] { return render(*arguments); }; });
}

}  // namespace pathmark::bench
