// pathmark contact-sheet: many scenes on one picture.
#include "film/contact_sheet.h"
#include "film/image_file.h"
#include "host/blob_file.h"
#include "host/commands.h"
#include "host/exit_code.h"
#include "host/interrupt.h"
#include "host/options.h"
#include "host/output_file.h"
#include "host/session.h"
#include "scene/limits.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

struct SheetArguments {
  std::vector<std::string> scenes;
  std::string with;
  std::uint64_t raysPerPixel = 256;
  int thumbnail = 160;
  std::string sampler = "sobol";
  std::vector<std::string> paths;  // none: all light
  std::string output = "contact_sheet.png";
};

std::vector<fs::path> findScenes(const std::vector<std::string>& scenes) {
  std::vector<fs::path> files;
  if (scenes.empty())
    for (const std::string& name : shippedSceneNames()) files.push_back(shippedSceneFile(name));
  files.reserve(scenes.size());
  for (const std::string& scene : scenes) files.push_back(findScene(scene));
  return files;
}

// A picture that is wanted.
struct Wish {
  fs::path scene;
  std::optional<PathExpression> paths{};
};

// Every scene once, or once for each expression.
std::vector<Wish> wishesFor(const SheetArguments& arguments) {
  std::vector<PathExpression> expressions;
  for (const std::string& text : arguments.paths) expressions.push_back(findPaths(text));
  std::vector<Wish> wishes;
  for (const fs::path& scene : findScenes(arguments.scenes)) {
    if (expressions.empty()) wishes.push_back({scene});
    for (const PathExpression& paths : expressions) wishes.push_back({scene, paths});
  }
  return wishes;
}

void refuseOutput(const SheetArguments& arguments, std::size_t scenes) {
  const fs::path file = arguments.output;
  if (file.extension() != ".png")
    throw UsageError(fmt::format("--output {}: a contact sheet is a .png file.", file.string()));
  requirePlaceForFile("--output", file);
  // A pixel takes 12 bytes while it is drawn.
  if (static_cast<double>(scenes) * arguments.thumbnail * arguments.thumbnail > double{kMostPixels})
    throw UsageError(fmt::format(
        "{} pictures of {} pixels do not fit on one sheet; a smaller --thumbnail helps.", scenes,
        arguments.thumbnail));
}

// The scene's own size is only known once it is read.
LoadedScene loadThumbnail(const fs::path& file, int thumbnail) {
  const FlatCamera camera = loadScene(file).flat.camera;
  SceneOverrides overrides;
  overrides.size =
      thumbnailSize(static_cast<int>(camera.width), static_cast<int>(camera.height), thumbnail);
  return loadScene(file, overrides);
}

// Fills the tile's picture, or its reason for having none; returns an exit code.
int renderTile(const Coursework& coursework, const Wish& wish, const SheetArguments& arguments,
               SheetTile& tile) {
  const LoadedScene scene = loadThumbnail(wish.scene, arguments.thumbnail);
  RenderOptions options;
  options.paths = wish.paths;
  options.raysPerPixel = arguments.raysPerPixel;
  options.sampler = findSampler(arguments.sampler);
  const RenderOutcome outcome = renderScene(coursework, scene, options);
  const RenderedImage& rendered = outcome.rendered;
  // Pixels that no ray has reached yet would look like pixels without a valid value.
  if (!rendered.complete && !rendered.image.invalid.empty()) return kInterrupted;
  tile.picture = rendered.image;
  tile.exposure = scene.exposure;
  fmt::print("{:<24} {:>9} {:>14.0f} {:>8.2f} {:>8.1f}\n", tile.label,
             fmt::format("{}x{}", rendered.image.width, rendered.image.height),
             rendered.raysPerPixel, rendered.seconds,
             static_cast<double>(rendered.raysTraced) / rendered.seconds * 1e-6);
  std::fflush(stdout);
  if (!rendered.complete) return kInterrupted;
  const std::string sentence = invalidSentence(rendered, Estimator::kPath);
  if (sentence.empty()) return kSuccess;
  fmt::print(stderr, "{}: {}\n", tile.label, sentence);
  return kCourseworkFault;
}

// A scene that fails costs its own tile only.
int renderOrExplain(const Coursework& coursework, const Wish& wish, const SheetArguments& arguments,
                    SheetTile& tile) {
  try {
    if (needsShippedBlobFile(wish.scene) && makeShippedBlobFile())
      fmt::print(stderr, "The mesh of the scene blob was made.\n");
    return renderTile(coursework, wish, arguments, tile);
  } catch (const SceneError& e) {
    tile.reason = "does not load";
    fmt::print(stderr, "{}\n", e.what());
    return kUsageFault;
  } catch (const WorkerError& e) {
    tile.reason = "coursework failed";
    fmt::print(stderr, "{}: {}\n", tile.label, e.what());
    return kCourseworkFault;
  }
}

// Named by their scenes, by their expressions, or by both where there are several of both.
std::vector<SheetTile> emptyTiles(const std::vector<Wish>& wishes) {
  std::vector<fs::path> files;
  files.reserve(wishes.size());
  for (const Wish& wish : wishes) files.push_back(wish.scene);
  const bool oneScene =
      std::all_of(files.begin(), files.end(), [&](const fs::path& f) { return f == files[0]; });
  std::vector<std::string> labels = sheetLabels(files);
  std::vector<SheetTile> tiles;
  for (std::size_t k = 0; k < wishes.size(); ++k) {
    std::string label = std::move(labels[k]);
    if (wishes[k].paths)
      label =
          oneScene ? wishes[k].paths->text() : fmt::format("{} {}", label, wishes[k].paths->text());
    tiles.push_back({.label = std::move(label), .reason = "not rendered"});
  }
  return tiles;
}

int contactSheet(const SheetArguments& arguments) {
  const std::vector<Wish> wishes = wishesFor(arguments);
  refuseOutput(arguments, wishes.size());
  findSampler(arguments.sampler);
  const Coursework coursework =
      prepareCoursework(arguments.with.empty() ? solvedCoursework() : arguments.with);
  fmt::print("{:<24} {:>9} {:>14} {:>8} {:>8}\n", "scene", "pixels", "rays per pixel", "seconds",
             "Mrays/s");
  std::fflush(stdout);
  std::vector<SheetTile> tiles = emptyTiles(wishes);
  int code = kSuccess;
  for (std::size_t k = 0; k < wishes.size() && !interrupted(); ++k)
    code = std::max(code, renderOrExplain(coursework, wishes[k], arguments, tiles[k]));
  if (interrupted()) code = kInterrupted;

  const Image sheet = drawContactSheet(tiles, arguments.thumbnail);
  writeImage(arguments.output, sheet, 1.0);
  const auto shown =
      std::count_if(tiles.begin(), tiles.end(), [](const auto& t) { return t.picture; });
  fmt::print("\n{}: {}x{}, {} of {} {}, with {}\n", arguments.output, sheet.width, sheet.height,
             shown, tiles.size(), arguments.paths.empty() ? "scenes" : "pictures", coursework.name);
  return code;
}

}  // namespace

void addContactSheetCommand(CLI::App& app, CommandAction& action) {
  const auto arguments = std::make_shared<SheetArguments>();
  CLI::App* command =
      app.add_subcommand("contact-sheet", "Render many scenes as small pictures on one");
  command
      ->add_option("SCENE", arguments->scenes,
                   "Scenes' names in scenes/ or student/scenes/, or .json files (default: all of "
                   "scenes/)")
      ->type_name("");
  command
      ->add_option("--with", arguments->with,
                   "Coursework: " + courseworkChoices(solvedCoursework()))
      ->type_name("DIR");
  takesWholeNumber(command->add_option("--rays-per-pixel", arguments->raysPerPixel,
                                       "Rays through each pixel (default: 256)"),
                   1, kMostRaysPerPixel);
  takesWholeNumber(command->add_option("--thumbnail", arguments->thumbnail,
                                       "Longer side of each picture in pixels (default: 160)"),
                   16, 1024);
  addSamplerOption(*command, arguments->sampler);
  command
      ->add_option("--paths", arguments->paths,
                   "Light path expressions: each scene once for each of them, with only the light "
                   "that came along such paths; handouts/light_paths.md tells more")
      ->type_name("EXPR...");
  command
      ->add_option("--output", arguments->output,
                   "The .png file to write (default: contact_sheet.png)")
      ->type_name("FILE");
  command->footer(
      "Examples:\n"
      "  ./pathmark contact-sheet\n"
      "  ./pathmark contact-sheet cornell_box furnace --with student --rays-per-pixel 16\n"
      "  ./pathmark contact-sheet submissions/*/scenes/*.json --output part7.png\n"
      "  ./pathmark contact-sheet cornell_phong --paths LE LDE LSE 'L..+E' 'L.*E'\n\n"
      "A scene that fails costs its own tile only. Ctrl-C writes what there is.\n"
      "Exit code: 0 done, 1 the coursework is at fault, 2 the command line or a scene is,\n"
      "3 the machine is, 130 interrupted.");
  command->callback(
      [arguments, &action] { action = [arguments] { return contactSheet(*arguments); }; });
}

}  // namespace pathmark
