// pathmark bench error: what estimators and samplers buy, as error against time.
#include "bench/bench_commands.h"
#include "bench/error_report.h"
#include "bench/machine.h"
#include "bench/report_file.h"
#include "film/atomic_file.h"
#include "host/exit_code.h"
#include "host/options.h"
#include "host/output_file.h"
#include "host/session.h"
#include "host/size_option.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <memory>

namespace pathmark::bench {

namespace {

struct BenchErrorArguments {
  std::vector<std::string> scenes;
  std::string with = solvedCoursework();
  std::vector<std::string> estimators;
  std::vector<std::string> samplers{"sobol"};
  std::string rays = "4,16,64";
  std::int64_t replicates = 8;
  std::int64_t seed = 0;
  double seconds = 0.0;
  std::string size;
  int maxBounces = -1;
  std::int64_t referenceRays = 8192;
  std::string reference;
  std::vector<std::string> peers;
  std::string csv, json, html, svg;
};

constexpr std::uint64_t kMostRays = 1'000'000;

std::vector<std::uint64_t> readRays(const std::string& text) {
  std::vector<std::uint64_t> rays;
  const char *at = text.data(), *end = at + text.size();
  for (;;) {
    std::uint64_t number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc{} || number == 0 || number > kMostRays ||
        (next != end && *next != ',') || (next != end && next + 1 == end))
      throw UsageError(fmt::format(
          "--rays {}: it is a list of numbers from 1 to {} with commas, such as 4,16,64.", text,
          kMostRays));
    rays.push_back(number);
    if (next == end) break;
    at = next + 1;
  }
  std::sort(rays.begin(), rays.end());
  rays.erase(std::unique(rays.begin(), rays.end()), rays.end());
  return rays;
}

void readPeerWords(const BenchErrorArguments& arguments, ErrorPlan& plan) {
  std::vector<std::string> images;
  for (const std::string& word : arguments.peers)
    if (word == "cycles")
      plan.cycles = true;
    else
      images.push_back(word);
  plan.peers = readPeers(images);
  for (const PeerImage& peer : plan.peers)
    if (peer.scene.empty() && plan.scenes.size() > 1)
      throw UsageError(fmt::format(
          "--peer {}: with several scenes it must be a .json file that says the image's scene.",
          peer.name));
}

ErrorPlan planFor(const BenchErrorArguments& arguments) {
  ErrorPlan plan;
  plan.scenes =
      arguments.scenes.empty() ? std::vector<std::string>{"cornell_box"} : arguments.scenes;
  plan.with = arguments.with;
  plan.estimators = findEstimators(arguments.with, arguments.estimators);
  for (const std::string& name : arguments.samplers)
    plan.samplers.push_back(findSampler(name, "--samplers"));
  plan.raysPerPixel = readRays(arguments.rays);
  plan.replicates = static_cast<std::uint64_t>(arguments.replicates);
  plan.seed = static_cast<std::uint64_t>(arguments.seed);
  plan.seconds = arguments.seconds;
  if (!arguments.size.empty()) plan.overrides.size = parseSize(arguments.size);
  if (arguments.maxBounces >= 0) plan.overrides.maxBounces = arguments.maxBounces;
  plan.referenceRays = static_cast<std::uint64_t>(arguments.referenceRays);
  plan.referenceFile = arguments.reference;
  if (!arguments.reference.empty() && plan.scenes.size() > 1)
    throw UsageError("--reference: it is the image of one scene, and there are several.");
  for (const std::string& scene : plan.scenes) {
    const std::string name = findScene(scene).stem().string();
    if (!arguments.csv.empty() && name.find_first_of(",\"\n\r") != std::string::npos)
      throw UsageError(fmt::format(
          "{}: with --csv a scene's name has no commas, quotes or line ends; rename the file.",
          scene));
  }
  readPeerWords(arguments, plan);
  return plan;
}

void refuseFiles(const BenchErrorArguments& arguments) {
  const std::pair<const char*, const std::string*> files[] = {{"--csv", &arguments.csv},
                                                              {"--json", &arguments.json},
                                                              {"--html", &arguments.html},
                                                              {"--svg", &arguments.svg}};
  for (const auto& [option, file] : files) {
    if (file->empty()) continue;
    requirePlaceForFile(option, *file);
    tryToWriteBeside(*file);
  }
}

// Now and then, so that a run that is killed loses a few seconds at most.
class KeptRuns {
 public:
  explicit KeptRuns(std::string file) : file_(std::move(file)) {
    if (!file_.empty() && std::filesystem::exists(file_))
      for (ErrorRun& run : readCsv(file_)) runs.add(std::move(run));
  }

  void write() const {
    if (!file_.empty()) writeFileAtomically(file_, csvOf(runs.all()));
  }
  void writeNowAndThen() {
    const auto now = std::chrono::steady_clock::now();
    if (now - written_ < std::chrono::seconds(2)) return;
    write();
    written_ = now;
  }

  ErrorRuns runs;

 private:
  std::string file_;
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
};

int error(const BenchErrorArguments& arguments) {
  refuseFiles(arguments);
  const ErrorPlan plan = planFor(arguments);
  KeptRuns kept(arguments.csv);
  const ErrorFindings findings = measureErrors(plan, kept.runs, [&] { kept.writeNowAndThen(); });
  kept.write();
  const std::string machine = machineLine();
  printErrors(findings, machine);
  if (!arguments.json.empty())
    writeFileAtomically(arguments.json, errorsJson(findings, kept.runs.all(), machine));
  if (!arguments.html.empty()) writeFileAtomically(arguments.html, errorsHtml(findings, machine));
  if (!arguments.svg.empty()) writeFileAtomically(arguments.svg, chartFile(errorCharts(findings)));
  if (findings.interrupted) {
    fmt::print(stderr, "Interrupted: this is what there was{}.\n",
               arguments.csv.empty() ? "" : "; the same command goes on from here");
    return kInterrupted;
  }
  return findings.fault ? kCourseworkFault : kSuccess;
}

void addMeasureOptions(CLI::App& command, BenchErrorArguments& arguments) {
  command.add_option("SCENE", arguments.scenes, "Scenes by name or file (default: cornell_box)")
      ->type_name("");
  command
      .add_option("--with", arguments.with, "Coursework: " + courseworkChoices(solvedCoursework()))
      ->type_name("DIR");
  command
      .add_option("--estimators", arguments.estimators,
                  "The coursework by its name, its labs by theirs, or NAME=FOLDER, with commas "
                  "(default: the coursework and all its labs); behind each may stand +mis, "
                  "+solid-angle, +splitN, +share-direct, +reuseN and +direct-pathsN, which are "
                  "render's options")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAMES");
  command
      .add_option("--samplers", arguments.samplers,
                  "sobol, stratified, pcg, with commas (default: sobol)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAMES");
  command.add_option("--rays", arguments.rays, "Rays per pixel, with commas (default: 4,16,64)")
      ->type_name("NUMBERS");
  takesWholeNumber(command.add_option("--replicates", arguments.replicates,
                                      "Renders of each, with seeds of their own (default: 8)"),
                   1, 10000);
  takesWholeNumber(
      command.add_option("--seed", arguments.seed, "Of the first replicate (default: 0)"), 0,
      1'000'000'000);
  takesSeconds(command.add_option("--seconds", arguments.seconds,
                                  "Measure for so long at most (default: until all is done)"),
               0.1, 1e6);
  command
      .add_option("--size", arguments.size, "Width x height, such as 64x64 (default: the scene's)")
      ->type_name("WxH");
  takesWholeNumber(command.add_option("--max-bounces", arguments.maxBounces,
                                      "Scattering events on a path: 1 is direct light (default: "
                                      "the scene's)"),
                   0, 1000);
  command.add_option("--reference", arguments.reference, "An image to compare with")
      ->type_name("FILE");
  takesWholeNumber(command.add_option("--reference-rays", arguments.referenceRays,
                                      "Rays per pixel of a reference that has to be made "
                                      "(default: 8192)"),
                   32, 100'000'000);
  command
      .add_option(
          "--peer", arguments.peers,
          "Another renderer: NAME=IMAGE,SECONDS or NAME=IMAGE,SECONDS,RAYS, a .json list of "
          "many, or cycles, which needs blender")
      ->type_name("PEER");
}

void addOutputOptions(CLI::App& command, BenchErrorArguments& arguments) {
  command
      .add_option("--csv", arguments.csv,
                  "Keep the single renders here; what is there already is not made again")
      ->type_name("FILE");
  addJsonOption(command, arguments.json);
  command.add_option("--html", arguments.html, "Write a page with plots and tables")
      ->type_name("FILE");
  command.add_option("--svg", arguments.svg, "Write the plots alone")->type_name("FILE");
}

}  // namespace

void addBenchErrorCommand(CLI::App& bench, CommandAction& action) {
  const auto arguments = std::make_shared<BenchErrorArguments>();
  CLI::App* command =
      bench.add_subcommand("error", "Error against time: estimators, samplers and other renderers");
  addMeasureOptions(*command, *arguments);
  addOutputOptions(*command, *arguments);
  command->footer(fmt::format(
      "Examples:\n"
      "  ./pathmark bench error --html error.html\n"
      "  ./pathmark bench error cornell_box --estimators uniform,cosine,hemispherical --csv "
      "error.csv\n"
      "  ./pathmark bench error cornell_box --estimators {0} --samplers "
      "pcg,stratified,sobol\n"
      "  ./pathmark bench error cornell_box --estimators "
      "{0},{0}+split4+share-direct,{0}+reuse16\n"
      "  ./pathmark bench error cornell_box --with student --size 64x64 --max-bounces 1\n"
      "  ./pathmark bench error cornell_box --estimators mine=student,theirs=../theirs/student\n"
      "  ./pathmark bench error cornell_box --peer cycles\n"
      "  ./pathmark bench error cornell_box --peer Mitsuba=box.exr,7.8,256\n\n"
      "An estimator is a coursework, or one of its labs: a folder COURSEWORK/labs/NAME with the "
      "files\n"
      "that it changes (handouts/labs.md). Renders are compared with the scene's reference, less "
      "the\n"
      "reference's own error; for another size or number of bounces a reference is made, with the\n"
      "coursework, and kept. Of Ctrl-C and --seconds what there is is shown.\n"
      "Exit code: 0 done, 1 an estimator is at fault, 2 the command line or the scene is, 3 the\n"
      "machine is, 130 interrupted.",
      solvedCoursework()));
  command->callback([arguments, &action] { action = [arguments] { return error(*arguments); }; });
}

}  // namespace pathmark::bench
