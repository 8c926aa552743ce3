// pathmark bench cost: that time is in proportion to pixels and to rays, and memory is not.
#include "bench/alternate.h"
#include "bench/bench_commands.h"
#include "bench/error_words.h"
#include "bench/interrupted_run.h"
#include "bench/log_chart.h"
#include "bench/machine.h"
#include "bench/page.h"
#include "bench/picture_folder.h"
#include "bench/render_cost.h"
#include "bench/report_file.h"
#include "bench/with_option.h"
#include "film/atomic_file.h"
#include "host/exit_code.h"
#include "host/options.h"
#include "host/output_file.h"
#include "host/session.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

namespace pathmark::bench {

namespace {

struct BenchCostArguments {
  std::string scene = "cornell_box";
  std::string with = solvedCoursework();
  std::string json, html, svg;
  std::int64_t repeats = 5;
  bool quick = false;
};

Interval meanOf(const std::vector<double>& values) {
  return jackknife(values.size(), [&](auto chosen) {
    double sum = 0.0;
    for (const std::size_t k : chosen) sum += values[k];
    return sum / static_cast<double>(chosen.size());
  });
}

void addTable(Report& report, const CostSweep& sweep, const std::string& key,
              const std::string& what) {
  Table table{key,
              fmt::format("Cost over {}; one thread, without the program's start", what),
              {{"amount", what, 0},
               {"cpuSeconds", "CPU s", 4},
               {"error", "+- 95 %", 4},
               {"microseconds", "us / camera ray", 3},
               {"megabytes", "memory, MB", 1}},
              {}};
  table.printHead();
  for (const CostPoint& p : sweep.points) {
    const Interval cpu = meanOf(p.cpuSeconds);
    table.add({fmt::format("{:.0f}", p.amount), cpu.value, cpu.high - cpu.value,
               microsecondsPerRay(p), meanOf(p.megabytes).value});
  }
  report.tables.push_back(std::move(table));
}

void addFigures(Report& report, const Cost& cost) {
  const auto add = [&](const char* key, const char* what, const CostSweep& sweep) {
    const Interval s = costSlope(sweep);
    report.figures.push_back(
        {.key = key,
         .name = fmt::format("time grows with {}, as a power", what),
         .value = s.value,
         .error = s.error,
         .note =
             fmt::format("1 is in proportion, and a picture is written once, whatever its rays; "
                         "95 % interval {:.3f} to {:.3f}",
                         s.low, s.high)});
  };
  add("raysExponent", "rays per pixel", cost.rays);
  add("pixelsExponent", "pixels", cost.pixels);
  report.figures.push_back(
      {.key = "memoryGrowth",
       .name = fmt::format("memory of {:.0f} rays per pixel beyond that of {:.0f}",
                           cost.rays.points.back().amount, cost.rays.points.front().amount),
       .value =
           median(cost.rays.points.back().megabytes) - median(cost.rays.points.front().megabytes),
       .unit = "MB",
       .target = Target{.must = 1.0, .moreIsBetter = false}});
}

LogChart chartOf(const std::string& scene, const CostSweep& sweep, const std::string& what,
                 bool memory) {
  LogChart chart{fmt::format("{}: {} over {}", scene, memory ? "memory" : "time", what),
                 what,
                 memory ? "memory, MB" : "CPU seconds",
                 {},
                 memory ? 0.0 : 1.0};
  ChartLine line{memory ? "host and worker" : "rendering", "", {}, memory ? 1 : 0, 0};
  if (!memory) line.note = fmt::format("slope {}", slopeWords(costSlope(sweep)));
  for (const CostPoint& p : sweep.points) {
    const Interval y = meanOf(memory ? p.megabytes : p.cpuSeconds);
    if (y.value > 0.0) line.points.push_back({p.amount, y.value, y.low, y.high});
  }
  chart.lines.push_back(std::move(line));
  return chart;
}

std::vector<LogChart> chartsOf(const std::string& scene, const Cost& cost) {
  return {chartOf(scene, cost.rays, "rays per pixel", false),
          chartOf(scene, cost.pixels, "pixels", false),
          chartOf(scene, cost.rays, "rays per pixel", true)};
}

std::string pageWith(const std::vector<LogChart>& charts, const std::string& machine) {
  std::string body =
      "<h1>What renders cost</h1>\n<p>Bars: 95 % intervals over repeated runs, of whole processes "
      "of one thread; time without the program's start. The dotted line is in proportion.</p>\n";
  for (const LogChart& chart : charts)
    body += fmt::format("<section><figure>{}</figure></section>\n", chartSvg(chart));
  return pageOf("What renders cost",
                fmt::format("{}<p class=\"soft\">{}</p>\n", body, escaped(machine)));
}

void refuseFiles(const BenchCostArguments& arguments) {
  refuseJsonFile(arguments.json);
  for (const auto& [option, file] :
       {std::pair{"--html", &arguments.html}, {"--svg", &arguments.svg}})
    if (!file->empty()) requirePlaceForFile(option, *file);
}

int cost(const BenchCostArguments& arguments) {
  refuseFiles(arguments);
  CostPlan plan;
  plan.scene = arguments.scene;
  plan.repeats = static_cast<int>(arguments.repeats);
  if (arguments.quick) {
    plan.raysPerPixel = {1, 4, 16};
    plan.sides = {32, 64, 128};
    plan.raysOfSides = 4;
    plan.repeats = 2;
  }
  findScene(plan.scene);
  const PictureFolder folder;
  const RenderRuns runs(prepareCoursework(arguments.with), folder.path());
  Progress progress("bench cost", plan.repeats * static_cast<double>(plan.raysPerPixel.size() +
                                                                     plan.sides.size()));
  Report report{.command = "bench cost", .machine = machineLine(), .tables = {}, .figures = {}};
  Cost measured;
  try {
    measured = measureCost(plan, runs, progress);
  } catch (const Interrupted&) {
    progress.clear();
    fmt::print(stderr, "Interrupted: nothing was written.\n");
    return kInterrupted;
  }
  progress.clear();
  addTable(report, measured.rays, "rays", "rays per pixel");
  addTable(report, measured.pixels, "pixels", "pixels");
  addFigures(report, measured);
  printFigures(report);
  writeJson(arguments.json, report);
  const std::vector<LogChart> charts = chartsOf(plan.scene, measured);
  if (!arguments.html.empty())
    writeFileAtomically(arguments.html, pageWith(charts, report.machine));
  if (!arguments.svg.empty()) writeFileAtomically(arguments.svg, chartFile(charts));
  return kSuccess;
}

}  // namespace

void addBenchCostCommand(CLI::App& bench, CommandAction& action) {
  const auto arguments = std::make_shared<BenchCostArguments>();
  CLI::App* command =
      bench.add_subcommand("cost", "Time and memory over the number of rays and of pixels");
  command->add_option("SCENE", arguments->scene, "By name or file (default: cornell_box)")
      ->type_name("");
  addWithOption(*command, arguments->with);
  takesWholeNumber(
      command->add_option("--repeats", arguments->repeats, "Runs of each (default: 5)"), 2, 1000);
  command->add_flag("--quick", arguments->quick, "Few rays and pixels: whether all of it works");
  addJsonOption(*command, arguments->json);
  command->add_option("--html", arguments->html, "Write a page with the plots")->type_name("FILE");
  command->add_option("--svg", arguments->svg, "Write the plots alone")->type_name("FILE");
  command->footer(
      "Examples:\n"
      "  ./pathmark bench cost\n"
      "  ./pathmark bench cost cornell_spheres --html cost.html\n"
      "  ./pathmark bench cost --with student --quick\n\n"
      "Whole processes of one thread; the time of a start, a render of one ray through one pixel, "
      "is\n"
      "subtracted. Powers are slopes of straight lines in plots with logarithmic axes.");
  command->callback([arguments, &action] { action = [arguments] { return cost(*arguments); }; });
}

}  // namespace pathmark::bench
