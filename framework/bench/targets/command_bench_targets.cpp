// pathmark bench targets: all that is asked of the program's speed, in one run.
#include "bench/bench_commands.h"
#include "bench/interrupted_run.h"
#include "bench/machine.h"
#include "bench/picture_folder.h"
#include "bench/progress.h"
#include "bench/report_file.h"
#include "bench/targets/marking_times.h"
#include "bench/targets/own_command.h"
#include "bench/targets/targets_chapter.h"
#include "bench/with_option.h"
#include "host/exit_code.h"
#include "host/output_file.h"
#include "host/session.h"
#include "host/shell_word.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace pathmark::bench {

namespace {

using Json = nlohmann::ordered_json;

struct BenchTargetsArguments {
  std::string with = solvedCoursework();
  std::string peer, json, handout;
  bool quick = false;
};

// The command line that does the same again.
std::string commandOf(const BenchTargetsArguments& arguments) {
  std::string line = "./pathmark bench targets";
  if (arguments.quick) line += " --quick";
  if (arguments.with != solvedCoursework()) line += " --with " + shellWord(arguments.with);
  if (!arguments.peer.empty()) line += " --peer " + arguments.peer;
  if (!arguments.handout.empty()) line += " --handout " + shellWord(arguments.handout);
  return line;
}

struct Part {
  std::vector<std::string> words;
  double seconds;  // about, for the progress
};

class TargetsBench {
 public:
  explicit TargetsBench(const BenchTargetsArguments& arguments)
      : arguments_(arguments),
        folder_(""),
        progress_("bench targets", 40.0 + secondsOfAll()),
        report_{.command = "bench targets", .machine = machineLine(), .tables = {}, .figures = {}} {
    findings_.command = commandOf(arguments);
    findings_.machine = report_.machine;
  }

  void run() {
    for (const Part& part : parts()) {
      const std::string line = fmt::format("bench {}", fmt::join(part.words, " "));
      progress_.show(line);
      take(line, ownReport(part.words, folder_.path(), [&](const LoggedProgress& own) {
             progress_.show(fmt::format("{}, {}", line, own.what), own.fraction, part.seconds);
           }));
      progress_.advance(part.seconds);
    }
    const std::size_t before = report_.figures.size();
    addMarkingTimes(findCoursework(arguments_.with), folder_.path(), progress_, report_);
    findings_.parts.push_back(
        {"./pathmark check, ./pathmark grade",
         {report_.figures.begin() + static_cast<std::ptrdiff_t>(before), report_.figures.end()}});
    progress_.clear();
  }

  void conclude() const {
    printFigures(report_);
    writeJson(arguments_.json, report_);
    if (!arguments_.handout.empty()) writeTargetsChapter(arguments_.handout, findings_);
  }

 private:
  std::vector<Part> parts() const {
    const auto with = [&](std::vector<std::string> words) {
      words.insert(words.end(), {"--with", arguments_.with});
      return words;
    };
    std::vector<std::string> render = with({"render"});
    if (!arguments_.peer.empty()) render.insert(render.end(), {"--peer", arguments_.peer});
    std::vector<std::string> lights = with({"lights", "cornell_box", "cornell_spheres", "blob"});
    if (arguments_.quick) {
      render.insert(render.end(), {"cornell_box", "--quick"});
      lights = with({"lights", "cornell_box", "--rays-per-pixel", "4", "--seeds", "2"});
      return {{{"rays", "--seconds", "0.001", "--most-triangles", "64"}, 20.0},
              {std::move(render), 30.0},
              {std::move(lights), 20.0},
              {with({"preview", "--saves", "1"}), 5.0}};
    }
    lights.insert(lights.end(), {"--rays-per-pixel", "256", "--seeds", "2"});
    return {{{"rays", "--large"}, 90.0},
            {std::move(render), arguments_.peer.empty() ? 120.0 : 400.0},
            {std::move(lights), 900.0},
            {with({"preview"}), 20.0}};
  }

  double secondsOfAll() const {
    double sum = 0.0;
    for (const Part& part : parts()) sum += part.seconds;
    return sum;
  }

  void take(const std::string& line, const Json& found) {
    std::vector<Figure> figures = targetedFigures(found);
    const Json& tables = found.at("tables");
    if (tables.contains("efficiency")) {
      findings_.efficiency = tables.at("efficiency");
      peers_ = figures;
    }
    if (tables.contains("lights")) {
      findings_.lights = tables.at("lights");
      figures = inTheBestWay(findings_.lights);
    }
    report_.figures.insert(report_.figures.end(), figures.begin(), figures.end());
    findings_.parts.push_back({"./pathmark " + line, std::move(figures)});
  }

  // The efficiency over the best peer's, times what the best of the ways of bench lights gains.
  std::vector<Figure> inTheBestWay(const Json& lights) const {
    std::vector<Figure> figures;
    for (const auto& [key, scene] : {std::pair{"s1", "cornell_box"},
                                     std::pair{"s2", "cornell_spheres"}, std::pair{"s3", "blob"}}) {
      const auto plain = std::ranges::find(peers_, std::string(key) + "OverBestPeer", &Figure::key);
      if (plain == peers_.end()) continue;
      Figure best = *plain;
      best.key += "InTheBestWay";
      best.name += ", in the best way";
      best.note = "no way is better than one tracePath for each camera ray";
      double gain = 1.0;
      for (const Json& row : lights) {
        const double ratio = row.at("efficiencyRatio");
        if (row.at("scene") != scene || ratio <= gain) continue;
        gain = ratio;
        best.value = plain->value * ratio;
        best.error = best.value * std::hypot(plain->error / plain->value,
                                             row.at("efficiencyRatioError").get<double>() / ratio);
        best.note =
            fmt::format("{}: {:.2f} times tracePath's", row.at("way").get<std::string>(), ratio);
      }
      figures.push_back(std::move(best));
    }
    return figures;
  }

  const BenchTargetsArguments& arguments_;
  PictureFolder folder_;
  Progress progress_;
  Report report_;
  TargetsFindings findings_;
  std::vector<Figure> peers_;
};

int benchTargets(const BenchTargetsArguments& arguments) {
  refuseJsonFile(arguments.json);
  if (!arguments.handout.empty()) requirePlaceForFile("--handout", arguments.handout);
  if (!arguments.peer.empty() && arguments.peer != "cycles")
    throw UsageError(fmt::format("--peer {}: cycles is the only one.", arguments.peer));
  prepareCoursework(arguments.with);
  try {
    TargetsBench bench(arguments);
    bench.run();
    bench.conclude();
    return kSuccess;
  } catch (const Interrupted&) {
    fmt::print(stderr, "Interrupted: nothing was written.\n");
    return kInterrupted;
  }
}

}  // namespace

void addBenchTargetsCommand(CLI::App& bench, CommandAction& action) {
  const auto arguments = std::make_shared<BenchTargetsArguments>();
  CLI::App* command = bench.add_subcommand(
      "targets", "All that is asked of the program's speed, in one run, as a table and a chapter");
  addWithOption(*command, arguments->with);
  command
      ->add_option("--peer", arguments->peer,
                   "Render the same with another program too: cycles, which needs blender")
      ->type_name("PEER");
  command->add_flag("--quick", arguments->quick,
                    "With fewer rays: whether all of it works, not how fast it is");
  addJsonOption(*command, arguments->json);
  command->add_option("--handout", arguments->handout, "Write the findings as a chapter, too")
      ->type_name("FILE");
  command->footer(
      "Examples:\n"
      "  ./pathmark bench targets\n"
      "  ./pathmark bench targets --quick\n"
      "  ./pathmark bench targets --peer cycles --handout handouts/performance.md\n\n"
      "Runs bench rays, render, lights and preview, check and grade, one after the other, which\n"
      "takes about 20 minutes, with a peer 30. Nothing else should run meanwhile.\n"
      "Exit code: 0 done, whatever was reached, 1 a command failed, 130 interrupted.");
  command->callback(
      [arguments, &action] { action = [arguments] { return benchTargets(*arguments); }; });
}

}  // namespace pathmark::bench
