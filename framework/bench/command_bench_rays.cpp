// pathmark bench rays: the flat loop against Embree, over the number of primitives.
#include "bench/bench_commands.h"
#include "bench/interrupted_run.h"
#include "bench/machine.h"
#include "bench/progress.h"
#include "bench/ray_rates.h"
#include "bench/report_file.h"
#include "host/exit_code.h"
#include "host/options.h"
#include "render/plan.h"
#include "scene/blob_mesh.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <memory>

namespace pathmark::bench {

namespace {

struct RaysArguments {
  double seconds = 0.15;
  std::int64_t mostTriangles = 4096;
  bool large = false;
  std::string json;
};

struct Kind {
  RayKind kind;
  const char* key;
  const char* title;
};

constexpr std::array<Kind, 4> kKinds{{
    {RayKind::kClosest, "closest", "Closest hit, independent diffuse bounces"},
    {RayKind::kOccluded, "occluded", "Shadow rays, independent"},
    {RayKind::kChained, "chained", "Closest hit, chained"},
    {RayKind::kPath, "path", "Chained, and a shadow ray from each vertex"},
}};

constexpr std::size_t kMostSpheres = 256;

// Triangles, if all are in pairs.
constexpr std::size_t kMostInLoop = 2 * kFewestForHierarchy;

// All measurements in one place: they share the time for each, the progress line and Ctrl-C.
class RaysBench {
 public:
  RaysBench(const RaysArguments& arguments, Report& report)
      : arguments_(arguments), report_(report), progress_("bench rays", measurements()) {}

  void run() {
    triangles();
    spheres();
    meshes();
    progress_.clear();
  }

 private:
  // Measurements of one intersector each; the search for the crossover takes about three pairs.
  double measurements() const {
    const auto powers = [](double most) { return std::floor(std::log2(most)) + 1.0; };
    return 4.0 * 3.0 * (powers(static_cast<double>(arguments_.mostTriangles)) + 1.0) +
           2.0 * (powers(kMostInLoop) + 1.0) + 4.0 * powers(kMostSpheres) +
           4.0 * 2.0 * (arguments_.large ? 4.0 : 3.0) + 9.0;
  }

  RayRates measure(const RaySubject& subject, RayKind kind) {
    progress_.show(fmt::format("{} primitives", subject.primitives()));
    const RayRates rates = subject.rates(kind, arguments_.seconds);
    stopIfInterrupted();
    progress_.advance((rates.flat > 0.0 ? 1.0 : 0.0) + (rates.embree > 0.0 ? 2.0 : 0.0));
    return rates;
  }

  void addFigure(Figure figure) { report_.figures.push_back(std::move(figure)); }

  void triangles() {
    std::deque<RaySubject> subjects;
    for (std::int64_t n = 1; n <= arguments_.mostTriangles; n *= 2) {
      progress_.show(fmt::format("preparing {} triangles", n));
      subjects.emplace_back(boxRoom(static_cast<std::size_t>(n)), RaySubject::Ways::kAll);
      if (n == 32)
        subjects.emplace_back(cornellBox(), RaySubject::Ways::kAll, "32: the Cornell box");
    }
    for (const Kind& kind : kKinds) triangleTable(kind, subjects);
    fanTable(subjects);
  }

  // As many as are rendered with the flat loop.
  void fanTable(const std::deque<RaySubject>& subjects) {
    Table table{"fans",
                fmt::format("Shadow rays of the flat loop from one point to {} of a lamp: million "
                            "rays per second and core",
                            kLanes),
                {{"triangles", "triangles", 0},
                 {"together", "at once"},
                 {"apart", "one by one"},
                 {"ratio", "ratio", 2}},
                {}};
    progress_.clear();
    table.printHead();
    for (const RaySubject& subject : subjects) {
      if (subject.primitives() >= kMostInLoop) continue;
      progress_.show(fmt::format("{} primitives", subject.primitives()));
      const FanRates r = subject.fanRates(arguments_.seconds);
      stopIfInterrupted();
      progress_.advance(2.0);
      progress_.clear();
      table.add({subject.label(), 1e-6 * r.together, 1e-6 * r.apart, r.together / r.apart});
    }
    report_.tables.push_back(std::move(table));
  }

  void triangleTable(const Kind& kind, const std::deque<RaySubject>& subjects) {
    Table table{kind.key,
                fmt::format("{}: million rays per second and core", kind.title),
                {{"triangles", "triangles", 0},
                 {"flat", "flat loop"},
                 {"embree", "Embree"},
                 {"rawEmbree", "raw Embree"},
                 {"flatOverEmbree", "flat/Embree", 2},
                 {"flatOverRawEmbree", "flat/raw", 2},
                 {"disagreement", "differ, ppm", 0}},
                {}};
    progress_.clear();
    table.printHead();
    std::vector<RatioAt> ratios;
    for (const RaySubject& subject : subjects) {
      const RayRates r = measure(subject, kind.kind);
      progress_.clear();
      const Cell differ =
          kind.kind == RayKind::kClosest ? Cell(1e6 * subject.disagreement()) : Cell();
      table.add({subject.label(), 1e-6 * r.flat, 1e-6 * r.embree, 1e-6 * r.raw, r.flat / r.embree,
                 r.flat / r.raw, differ});
      if (!subject.label().isNumber) {
        if (kind.kind == RayKind::kClosest) cornellFigures(r);
      } else {
        ratios.push_back({subject.primitives(), r.flat / r.embree});
      }
    }
    if (kind.kind == RayKind::kPath) crossover(ratios);
    report_.tables.push_back(std::move(table));
  }

  void cornellFigures(const RayRates& r) {
#if defined(__AVX512F__)
    const Target target{3.0, 5.0};
#else
    const Target target{2.5, 4.0};
#endif
    addFigure(
        {.key = "flatOverRawEmbreeAt32",
         .name = "flat loop / raw Embree, 32 triangles, independent rays",
         .value = r.flat / r.raw,
         .target = target,
         .note = "raw Embree is rtcIntersect1 in its fastest setting, which is not watertight"});
    addFigure({.key = "flatOverEmbreeAt32",
               .name = "flat loop / Embree as used (robust), the same",
               .value = r.flat / r.embree});
  }

  struct RatioAt {
    std::size_t triangles;
    double ratio;
  };

  // The number from which Embree is faster, to the flat loop's blocks of 16: between the last power
  // of two at which the flat loop is faster and the next, rooms are measured by bisection.
  void crossover(const std::vector<RatioAt>& ratios) {
    std::size_t low = 0;
    for (const RatioAt& r : ratios)
      if (r.ratio >= 1.0) low = r.triangles;
    const bool beyond = low == ratios.back().triangles;
    constexpr std::size_t kBlock = 16;
    for (std::size_t high = beyond ? low : 2 * low; high - low > kBlock;) {
      const std::size_t middle = (low + high) / 2 / kBlock * kBlock;
      const RaySubject subject(boxRoom(middle), RaySubject::Ways::kAll);
      const RayRates r = measure(subject, RayKind::kPath);
      (r.flat >= r.embree ? low : high) = middle;
    }
    addFigure(
        {.key = "crossover",
         .name = "most triangles for which the flat loop is faster",
         .value = static_cast<double>(low),
         .note = fmt::format("chained rays with shadow rays{}; whole renders, whose camera rays go "
                             "through a hierarchy in packets, take the flat loop for fewer than {} "
                             "(bench skip --rooms)",
                             beyond ? ", and more were not measured" : "", kMostInLoop)});
  }

  void spheres() {
    Table table{"spheres",
                "Spheres, flat loop: million rays per second and core",
                {{"spheres", "spheres", 0}},
                {}};
    for (const Kind& kind : kKinds) table.columns.push_back({kind.key, kind.key});
    progress_.clear();
    table.printHead();
    for (std::size_t n = 1; n <= kMostSpheres; n *= 2) {
      const RaySubject subject(sphereRoom(n), RaySubject::Ways::kFlatOnly);
      std::vector<Cell> row{subject.label()};
      for (const Kind& kind : kKinds) row.emplace_back(1e-6 * measure(subject, kind.kind).flat);
      progress_.clear();
      table.add(std::move(row));
    }
    report_.tables.push_back(std::move(table));
  }

  // Of a ball on a floor, by Embree as scenes are rendered with it, and by raw Embree.
  void meshes() {
    Table table{"meshes",
                "Meshes, Embree: million rays per second and core",
                {{"triangles", "triangles", 0}},
                {}};
    for (const Kind& kind : kKinds) {
      table.columns.push_back({kind.key, kind.key});
      table.columns.push_back({std::string(kind.key) + "Raw", "raw"});
    }
    progress_.clear();
    table.printHead();
    std::vector<RayRates> independent, path;
    std::vector<std::vector<Cell>> again;
    for (const int n : {11, 35, 112, kBlobSubdivisions}) {
      if (n == kBlobSubdivisions && !hasRoomForLarge()) break;
      progress_.show("preparing a mesh");
      const RaySubject subject(blobOnFloor(n), RaySubject::Ways::kEmbreeOnly);
      std::vector<Cell> row{subject.label()};
      for (const Kind& kind : kKinds) {
        const RayRates r = measure(subject, kind.kind);
        if (kind.kind == RayKind::kClosest) independent.push_back(r);
        if (kind.kind == RayKind::kPath) path.push_back(r);
        row.insert(row.end(), {1e-6 * r.embree, 1e-6 * r.raw});
      }
      progress_.clear();
      table.add(std::move(row));
      if (n == kBlobSubdivisions) again = measureAgain(subject);
    }
    growth("growthOfIndependent", "independent rays", independent);
    growth("growthOfPaths", "chained rays with shadow rays", path);
    report_.tables.push_back(std::move(table));
    if (!again.empty()) againTable(std::move(again));
  }

  std::vector<std::vector<Cell>> measureAgain(const RaySubject& subject) {
    std::vector<std::size_t> numbers;
    for (std::size_t n = 1024; n < subject.rays(); n *= 8) numbers.push_back(n);
    numbers.push_back(subject.rays());
    progress_.show("the same rays again");
    const std::vector<double> rates = subject.rawRates(numbers, arguments_.seconds);
    stopIfInterrupted();
    progress_.advance(static_cast<double>(numbers.size()));
    std::vector<std::vector<Cell>> rows;
    for (std::size_t k = 0; k < numbers.size(); ++k)
      rows.push_back({static_cast<double>(numbers[k]), 1e-6 * rates[k]});
    return rows;
  }

  // A measurement with few rays says of a large scene how fast its caches are.
  void againTable(std::vector<std::vector<Cell>> rows) {
    Table table{"repeated",
                "The million triangles, raw Embree, closest hit, when so many independent rays "
                "come again and again: million rays per second and core",
                {{"rays", "rays", 0}, {"raw", "raw"}},
                {}};
    table.printHead();
    for (std::vector<Cell>& row : rows) table.add(std::move(row));
    report_.tables.push_back(std::move(table));
  }

  bool hasRoomForLarge() const {
    if (!arguments_.large) return false;
    constexpr std::uint64_t kNeeded = std::uint64_t{800} << 20;  // two hierarchies, and the arrays
    if (availableMemory() >= kNeeded) return true;
    progress_.clear();
    fmt::print(stderr, "A million triangles are left out: they need {} MB, and {} MB are free.\n",
               kNeeded >> 20, availableMemory() >> 20);
    return false;
  }

  void growth(const char* key, const char* what, const std::vector<RayRates>& rates) {
    const bool toAMillion = rates.size() == 4;
    Figure figure{.key = key,
                  .name = fmt::format("{}, cost from 1,000 triangles to {}", what,
                                      toAMillion ? "1,000,000" : "100,000"),
                  .value = rates.front().embree / rates.back().embree,
                  .note = fmt::format("raw Embree's {:.2f}; bench render has that of whole renders",
                                      rates.front().raw / rates.back().raw)};
    if (toAMillion) figure.target = Target{.must = 2.5, .moreIsBetter = false};
    addFigure(std::move(figure));
  }

  const RaysArguments& arguments_;
  Report& report_;
  mutable Progress progress_;
};

int rays(const RaysArguments& arguments) {
  refuseJsonFile(arguments.json);
  Report report{.command = "bench rays", .machine = machineLine(), .tables = {}, .figures = {}};
  try {
    RaysBench(arguments, report).run();
  } catch (const Interrupted&) {
    fmt::print(stderr, "Interrupted: no JSON was written.\n");
    return kInterrupted;
  }
  printFigures(report);
  writeJson(arguments.json, report);
  return kSuccess;
}

}  // namespace

void addBenchRaysCommand(CLI::App& bench, CommandAction& action) {
  const auto arguments = std::make_shared<RaysArguments>();
  CLI::App* command =
      bench.add_subcommand("rays", "Rays per second of the flat loop and of Embree");
  takesSeconds(command->add_option("--seconds", arguments->seconds,
                                   "CPU seconds for each measurement, of which there are about "
                                   "230 (default: 0.15)"),
               1e-4, 60.0);
  takesWholeNumber(command->add_option("--most-triangles", arguments->mostTriangles,
                                       "Where the flat loop's rows end (default: 4096)"),
                   32, 65536);
  command->add_flag("--large", arguments->large,
                    "Also the million triangles of the scene blob, if there is memory for them");
  addJsonOption(*command, arguments->json);
  command->footer(
      "Examples:\n"
      "  ./pathmark bench rays\n"
      "  ./pathmark bench rays --large --json rays.json\n"
      "  ./pathmark bench rays --seconds 1        (steadier)\n\n"
      "One thread. The intersectors take turns in five rounds, of which the median counts; time "
      "is\n"
      "the thread's own, so that other programs disturb ratios little. Independent rays are "
      "diffuse\n"
      "bounces of light paths, prepared beforehand. A chained ray starts where the one before has\n"
      "met the scene, so that none begins before the last has ended, as in a render. Triangles "
      "are\n"
      "rooms with turned boxes. The ppm in the first table are rays for which the flat loop and\n"
      "Embree find different distances: rays through edges.");
  command->callback([arguments, &action] { action = [arguments] { return rays(*arguments); }; });
}

}  // namespace pathmark::bench
