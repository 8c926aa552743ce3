// pathmark bench skip: what each thing that a scene's plan leaves out saves, and what some that are
// not left out would save.
#include "bench/bench_commands.h"
#include "bench/interrupted_run.h"
#include "bench/machine.h"
#include "bench/progress.h"
#include "bench/report_file.h"
#include "bench/skip/box_room.h"
#include "bench/skip/edited_coursework.h"
#include "bench/skip/render_pair.h"
#include "bench/stress/coarse_blob.h"
#include "bench/with_option.h"
#include "host/blob_file.h"
#include "host/exit_code.h"
#include "host/options.h"
#include "intersect/intersector.h"
#include "intersect/triangle_pairs.h"
#include "scene/read_text.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <optional>
#include <span>

namespace pathmark::bench {

namespace {

struct BenchSkipArguments {
  std::vector<std::string> scenes;
  std::string with = solvedCoursework();
  std::string json;
  int rounds = 15;
  bool quick = false, rooms = false;
};

struct SkipLine {
  Skip skip;
  const char* key;
  const char* what;
};

constexpr std::array kSkips{
    SkipLine{Skip::kHierarchyOfFew, "hierarchy of few", "few triangles in a flat loop"},
    SkipLine{Skip::kLoopOverMany, "loop over many", "many triangles in a hierarchy"},
    SkipLine{Skip::kBoundingSurfaces, "bounding surfaces", "shadow rays against what bounds all"},
    SkipLine{Skip::kSecondTriangles, "second triangles", "two triangles of a quad as one"},
    SkipLine{Skip::kBackTests, "back tests", "backs where no triangle hides one"},
    SkipLine{Skip::kEmptyKinds, "empty kinds", "spheres or triangles where there are none"},
    SkipLine{Skip::kSingleCameraRays, "single camera rays", "those of a pixel as packets"},
};

bool hasPairs(const FlatSceneView& view) {
  std::vector<std::uint32_t> all(view.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  return std::ranges::any_of(pairTriangles(view, all),
                             [](const TrianglePair& pair) { return !pair.single; });
}

// A loop over more would take hours, and is no question.
constexpr std::size_t kMostInLoop = 5000;

// Whether the scene's plan has the skip at all.
bool applies(Skip skip, const FlatSceneView& view) {
  const Plan plan = planFor(view);
  const bool flat = plan.triangles == TriangleTest::kFlatLoop;
  switch (skip) {
    case Skip::kHierarchyOfFew:
      return flat;
    case Skip::kLoopOverMany:
      return plan.triangles == TriangleTest::kHierarchy && view.triangles.size() <= kMostInLoop;
    case Skip::kBoundingSurfaces:
      return (flat && plan.occludingTriangles.size() < view.triangles.size()) ||
             plan.occludingSpheres.size() < view.spheres.size();
    case Skip::kSecondTriangles:
      return flat && hasPairs(view);
    case Skip::kBackTests:
      return flat && !view.anyFrontOnly();
    case Skip::kEmptyKinds:
      return !flat || view.spheres.empty();
    case Skip::kSingleCameraRays:
      return plan.cameraRaysTogether;
  }
  return false;
}

std::string sameness(const PairResult& r) {
  if (r.differing == 0) return "same bits";
  return fmt::format("{:.1e}, {:.1e}", r.difference.mean, r.difference.block);
}

// What a path that rounding sends another way may change: see bench stress, similarity.
bool isSame(const PairResult& r, std::uint64_t rays) {
  return r.differing == 0 || (r.difference.mean <= 1e-3 &&
                              r.difference.block <= 1e-3 * 4096.0 / static_cast<double>(rays));
}

// Rays of a pixel by tile: none where all of many rays through it leave the scene.
std::vector<std::uint64_t> raysWithoutEmptyTiles(const LoadedScene& scene, std::uint64_t rays) {
  const FlatSceneView view = viewOf(scene.flat);
  const Intersector intersector(view, planFor(view));
  const FlatCamera& c = view.camera;
  const auto vector = [](const Float3& v) { return vec3(v[0], v[1], v[2]); };
  const auto meets = [&](float x, float y) {
    const Vector direction =
        normalize(vector(c.topLeft) + x * vector(c.pixelRight) + y * vector(c.pixelDown));
    PrimitiveHit hit;
    return intersector.closest({vector(c.eye), direction}, hit);
  };
  const int width = static_cast<int>(c.width), height = static_cast<int>(c.height);
  const int across = (width + kTileSize - 1) / kTileSize;
  std::vector<std::uint64_t> byTile(tileCount(width, height), 0);
  constexpr int kSteps = 4;  // of a pixel, both ways
  for (int j = 0; j < height * kSteps; ++j)
    for (int i = 0; i < width * kSteps; ++i) {
      const auto tile =
          static_cast<std::size_t>(j / kSteps / kTileSize * across + i / kSteps / kTileSize);
      if (byTile[tile] == 0 &&
          meets((static_cast<float>(i) + 0.5f) / kSteps, (static_cast<float>(j) + 0.5f) / kSteps))
        byTile[tile] = rays;
    }
  return byTile;
}

int sideOf(const BenchSkipArguments& arguments) { return arguments.quick ? 32 : 64; }

class SkipBench {
 public:
  SkipBench(const BenchSkipArguments& arguments, Coursework coursework, std::size_t scenes)
      : coursework_(std::move(coursework)),
        plan_{arguments.quick ? 16u : 64u, arguments.rounds},
        side_(sideOf(arguments)),
        progress_("bench skip", static_cast<double>(scenes * (kSkips.size() + 3) +
                                                    (arguments.rooms ? kBoxes.size() : 0))),
        report_{.command = "bench skip", .machine = machineLine(), .tables = {}, .figures = {}} {
    const std::vector<Column> columns{
        {"scene", "scene"},      {"what", "left out"}, {"ratio", "time without", 3},
        {"low", "quartiles", 3}, {"high", "", 3},      {"same", "picture: mean, worst block"}};
    skips_ = {.key = "skips",
              .title = "What plans leave out: CPU time without the skip, over that with it",
              .columns = columns,
              .rows = {}};
    candidates_ = {.key = "candidates",
                   .title = "What could be left out: CPU time now, over that if it were",
                   .columns = columns,
                   .rows = {}};
    candidates_.columns[2].title = "time now";
    rooms_ = {.key = "rooms",
              .title = "Rooms of boxes: CPU time through a hierarchy, over that in a flat loop",
              .columns = {{"pairs", "pairs of triangles", 0},
                          {"ratio", "time through a hierarchy", 3},
                          {"low", "quartiles", 3},
                          {"high", "", 3}},
              .rows = {}};
    // The shadow ray comes first.
    alwaysShadow_ = EditedCoursework::make(
        coursework_,
        {"part2_lights.cpp",
         "if (cosX <= 0.0f || cosY <= 0.0f || !scene.visible(hit, y)) return Colour(0.0f);",
         "if (!scene.visible(hit, y) || cosX <= 0.0f || cosY <= 0.0f) return Colour(0.0f);"});
    noShadowOfBlack_ = EditedCoursework::make(
        coursework_,
        {"part2_lights.cpp",
         "if (cosX <= 0.0f || cosY <= 0.0f || !scene.visible(hit, y)) return Colour(0.0f);",
         "if (cosX <= 0.0f || cosY <= 0.0f) return Colour(0.0f);\n"
         "  if (hit.brdf->brdf(wo, wi, hit.n) == Colour(0.0f)) return Colour(0.0f);\n"
         "  if (!scene.visible(hit, y)) return Colour(0.0f);"});
  }

  void measureSkips(const std::vector<LoadedScene>& scenes) {
    skips_.printHead();
    for (const LoadedScene& scene : scenes) {
      const FlatSceneView view = viewOf(scene.flat);
      for (const SkipLine& line : kSkips) {
        if (applies(line.skip, view))
          measure(skips_, scene, line.what, {coursework_},
                  {coursework_, Skips().without(line.skip)});
        progress_.advance(1.0);
      }
      if (alwaysShadow_ && !view.lights.empty())
        measure(skips_, scene, "shadow rays to what faces away", {coursework_},
                {alwaysShadow_->coursework()});
      progress_.advance(1.0);
    }
  }

  void measureCandidates(const std::vector<LoadedScene>& scenes) {
    progress_.clear();
    candidates_.printHead();
    for (const LoadedScene& scene : scenes) {
      const std::vector<std::uint64_t> rays = raysWithoutEmptyTiles(scene, plan_.rays);
      if (std::ranges::any_of(rays, [](std::uint64_t r) { return r == 0; }))
        measure(candidates_, scene, "tiles that see nothing", {coursework_, Skips(), rays},
                {coursework_});
      progress_.advance(1.0);
      if (noShadowOfBlack_ && !scene.flat.lights.empty())
        measure(candidates_, scene, "shadow rays of black surfaces",
                {noShadowOfBlack_->coursework()}, {coursework_});
      progress_.advance(1.0);
    }
  }

  // From how many triangles on the hierarchy is faster.
  void measureRooms() {
    progress_.clear();
    rooms_.printHead();
    double below = 0.0, ratioBelow = 0.0;
    std::optional<double> crossover;
    for (const int boxes : kBoxes) {
      progress_.show(fmt::format("a room of {} boxes", boxes));
      const PairResult r =
          renderInTurn(boxRoom(boxes, side_), {coursework_, Skips().without(Skip::kLoopOverMany)},
                       {coursework_, Skips().without(Skip::kHierarchyOfFew)}, plan_);
      const double pairs = pairsInBoxRoom(boxes);
      progress_.clear();
      rooms_.add({pairs, r.ratio, r.low, r.high});
      progress_.advance(1.0);
      if (!crossover && r.ratio <= 1.0 && below > 0.0)
        crossover = below + (pairs - below) * (ratioBelow - 1.0) / (ratioBelow - r.ratio);
      below = pairs;
      ratioBelow = r.ratio;
    }
    if (crossover)
      report_.figures.push_back({.key = "crossover",
                                 .name = "pairs and single triangles for which both take as long",
                                 .value = *crossover,
                                 .note = fmt::format("renders take the flat loop for fewer than {}",
                                                     kFewestForHierarchy)});
  }

  // Returns whether all pictures were the same.
  bool conclude(const std::string& json) {
    progress_.clear();
    report_.tables = {skips_, candidates_, rooms_};
    report_.figures.push_back({.key = "different",
                               .name = "renders whose picture depends on a skip",
                               .value = different_,
                               .target = Target{0.0, std::nullopt, false}});
    printFigures(report_);
    writeJson(json, report_);
    return different_ == 0.0;
  }

 private:
  void measure(Table& table, const LoadedScene& scene, const std::string& what,
               const RenderSide& with, const RenderSide& without) {
    progress_.show(fmt::format("{}, {}", scene.name, what));
    const PairResult result = renderInTurn(scene, with, without, plan_);
    if (!isSame(result, plan_.rays)) ++different_;
    progress_.clear();
    table.add({scene.name, what, result.ratio, result.low, result.high, sameness(result)});
  }

  static constexpr std::array kBoxes{4, 9, 14, 20, 28, 40};

  Coursework coursework_;
  PairPlan plan_;
  int side_;
  Progress progress_;
  Report report_;
  Table skips_, candidates_, rooms_;
  std::unique_ptr<EditedCoursework> alwaysShadow_, noShadowOfBlack_;
  double different_ = 0.0;
};

std::vector<LoadedScene> load(const BenchSkipArguments& arguments) {
  const int side = sideOf(arguments);
  SceneOverrides overrides;
  overrides.size = {side, side};
  std::vector<LoadedScene> scenes;
  for (const std::string& name :
       arguments.scenes.empty() ? shippedSceneNames() : arguments.scenes) {
    const std::filesystem::path file = findScene(name);
    if (needsShippedBlobFile(file)) {
      constexpr int kSubdivisions = 10;
      const CoarseBlob blob(kSubdivisions);
      scenes.push_back(loadScene(
          SceneSource{blob.sceneFile(), readText(file, "a scene is a JSON file")}, overrides));
    } else {
      scenes.push_back(loadScene(file, overrides));
    }
  }
  return scenes;
}

int measureAll(const BenchSkipArguments& arguments) {
  refuseJsonFile(arguments.json);
  const std::vector<LoadedScene> scenes = load(arguments);
  try {
    SkipBench bench(arguments, prepareCoursework(arguments.with), scenes.size());
    bench.measureSkips(scenes);
    bench.measureCandidates(scenes);
    if (arguments.rooms) bench.measureRooms();
    return bench.conclude(arguments.json) ? kSuccess : kCourseworkFault;
  } catch (const Interrupted&) {
    fmt::print(stderr, "Interrupted: no JSON was written.\n");
    return kInterrupted;
  }
}

}  // namespace

void addBenchSkipCommand(CLI::App& bench, CommandAction& action) {
  const auto arguments = std::make_shared<BenchSkipArguments>();
  CLI::App* command = bench.add_subcommand(
      "skip", "What is saved by leaving out what a scene does not need, one by one");
  command
      ->add_option(
          "SCENE", arguments->scenes,
          "Scenes by name, or .json files (default: those in scenes/; blob with few triangles)")
      ->type_name("");
  addWithOption(*command, arguments->with);
  takesWholeNumber(command->add_option("--rounds", arguments->rounds,
                                       "Renders of each kind, in turn (default: 15)"),
                   3, 1000);
  command->add_flag("--rooms", arguments->rooms,
                    "Also rooms of more and more boxes: from how many triangles on a hierarchy is "
                    "faster than a loop");
  command->add_flag("--quick", arguments->quick, "Small pictures: whether all of it works");
  addJsonOption(*command, arguments->json);
  command->footer(
      "Examples:\n"
      "  ./pathmark bench skip\n"
      "  ./pathmark bench skip cornell_box --rounds 51\n"
      "  ./pathmark bench skip cornell_box --rooms\n"
      "  ./pathmark bench skip blob furnace --json skip.json\n"
      "  ./pathmark render cornell_box --explain     what is left out in a scene, and why\n\n"
      "Each render is made with a skip and without it, in turn, by one thread with the same "
      "random\n"
      "numbers; the ratio is that of the workers' CPU times. Where the picture has other bits, "
      "the\n"
      "relative difference of its mean and of its worst block of 8x8 pixels is shown.\n"
      "Exit code: 0 done, 1 a picture depends on a skip, 130 interrupted.");
  command->callback(
      [arguments, &action] { action = [arguments] { return measureAll(*arguments); }; });
}

}  // namespace pathmark::bench
