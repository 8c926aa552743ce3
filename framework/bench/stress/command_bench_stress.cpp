// pathmark bench stress: over which range of scales, places, lights, materials and numbers renders
// stay right.
#include "bench/bench_commands.h"
#include "bench/cycles_peer.h"
#include "bench/interrupted_run.h"
#include "bench/machine.h"
#include "bench/report_file.h"
#include "bench/stress/stress.h"
#include "bench/stress/stress_chapter.h"
#include "bench/with_option.h"
#include "host/exit_code.h"
#include "host/output_file.h"
#include "host/session.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace pathmark::bench {

namespace {

struct BenchStressArguments {
  std::vector<std::string> only;
  std::string with = solvedCoursework();
  std::string json, handout, peer;
  bool quick = false;
};

std::vector<StressPart> wantedParts(const std::vector<std::string>& only) {
  const auto isPart = [&](const std::string& name) {
    return std::ranges::any_of(stressParts(), [&](const StressPart& p) { return p.name == name; });
  };
  std::vector<std::string> names;
  for (const StressPart& part : stressParts()) names.emplace_back(part.name);
  for (const std::string& name : only)
    if (!isPart(name))
      throw UsageError(fmt::format("--only {}: it is one of {}.", name, fmt::join(names, ", ")));
  std::vector<StressPart> parts;
  for (const StressPart& part : stressParts())
    if (only.empty() || std::ranges::find(only, part.name) != only.end()) parts.push_back(part);
  return parts;
}

// Before minutes of other work.
void refusePeer(const std::string& peer) {
  if (peer.empty()) return;
  if (peer != "cycles") throw UsageError(fmt::format("--peer {}: cycles is the only one.", peer));
  if (!CyclesPeer::find({}))
    throw UsageError(
        "--peer cycles: there is no program blender; on Debian and Ubuntu it is the package "
        "blender.");
}

bool reachesAll(const Report& report) {
  return std::ranges::none_of(report.figures,
                              [](const Figure& f) { return f.verdict() == "not met"; });
}

void addInvalid(Stress& stress) {
  stress.addFaults("invalid", "values in all pictures that are NaN, infinite or negative",
                   static_cast<double>(stress.invalid.count()),
                   fmt::format("of {:.0f} passes of pixels", stress.passes));
}

int stressAll(const BenchStressArguments& arguments) {
  const std::vector<StressPart> parts = wantedParts(arguments.only);
  refusePeer(arguments.peer);
  refuseJsonFile(arguments.json);
  if (!arguments.handout.empty()) requirePlaceForFile("--handout", arguments.handout);
  double steps = 0.0;
  for (const StressPart& part : parts) steps += part.steps;
  if (!arguments.peer.empty()) steps += kStepsOfPeer;
  Stress stress{
      .coursework = prepareCoursework(arguments.with),
      .quick = arguments.quick,
      .progress = Progress("bench stress", steps),
      .report = {.command = "bench stress", .machine = machineLine(), .tables = {}, .figures = {}}};
  try {
    for (const StressPart& part : parts) part.run(stress);
    if (!arguments.peer.empty()) stressPeer(stress);
  } catch (const Interrupted&) {
    stress.progress.clear();
    fmt::print(stderr, "Interrupted: nothing was written.\n");
    return kInterrupted;
  }
  addInvalid(stress);
  stress.progress.clear();
  printFigures(stress.report);
  writeJson(arguments.json, stress.report);
  if (!arguments.handout.empty()) writeStressChapter(arguments.handout, stress.report);
  return reachesAll(stress.report) ? kSuccess : kCourseworkFault;
}

}  // namespace

void addBenchStressCommand(CLI::App& bench, CommandAction& action) {
  const auto arguments = std::make_shared<BenchStressArguments>();
  CLI::App* command = bench.add_subcommand(
      "stress", "Over which range of scenes, lights, materials and numbers renders stay right");
  command
      ->add_option("--only", arguments->only,
                   "Only this part: similarity, lights, materials, input, long-runs, threads or "
                   "degenerate; may be given several times")
      ->type_name("NAME");
  addWithOption(*command, arguments->with);
  command->add_flag("--quick", arguments->quick,
                    "With fewer rays and fewer places: less than a minute instead of ten");
  command
      ->add_option("--peer", arguments->peer,
                   "Also how far another renderer's pictures stay the same: cycles, which needs "
                   "blender")
      ->type_name("PEER");
  addJsonOption(*command, arguments->json);
  command->add_option("--handout", arguments->handout, "Write the findings as a chapter, too")
      ->type_name("FILE");
  command->footer(
      "Examples:\n"
      "  ./pathmark bench stress --quick\n"
      "  ./pathmark bench stress --only lights --only materials\n"
      "  ./pathmark bench stress --with student --only input\n"
      "  ./pathmark bench stress --json stress.json --peer cycles --handout handouts/stress.md\n\n"
      "Expected values are closed forms and quadratures in long double, or the same scene "
      "elsewhere.\n"
      "The bounds are the solutions': coursework that is right but noisier, or less careful at "
      "the\n"
      "far ends, can miss some, and that is no mistake of the course.\n"
      "Exit code: 0 all that must hold holds, 1 something does not, or the coursework failed,\n"
      "2 the command line is wrong, 130 interrupted.");
  command->callback(
      [arguments, &action] { action = [arguments] { return stressAll(*arguments); }; });
}

}  // namespace pathmark::bench
