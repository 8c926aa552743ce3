// pathmark export: a scene for another renderer.
#include "export/export_scene.h"
#include "film/atomic_file.h"
#include "film/printable.h"
#include "host/blob_file.h"
#include "host/commands.h"
#include "host/display_path.h"
#include "host/exit_code.h"
#include "host/options.h"
#include "host/output_file.h"
#include "host/session.h"
#include "host/shell_word.h"
#include "host/size_option.h"
#include "scene/limits.h"
#include "scene/utf8.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <ranges>
#include <string>
#include <string_view>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

struct ExportArguments {
  std::string scene;
  std::string format;
  std::string output;
  std::string size;
  std::int64_t raysPerPixel = 0;  // 0: the scene's
  int maxBounces = -1;            // -1: the scene's
};

ExportFormat findFormat(const std::string& name) {
  if (name == "pbrt") return ExportFormat::kPbrt;
  if (name == "mitsuba") return ExportFormat::kMitsuba;
  throw UsageError(fmt::format("--format {}: it is pbrt or mitsuba.", name));
}

LoadedScene load(const ExportArguments& arguments) {
  SceneOverrides overrides;
  if (!arguments.size.empty()) overrides.size = parseSize(arguments.size);
  if (arguments.maxBounces >= 0) overrides.maxBounces = arguments.maxBounces;
  const fs::path file = findScene(arguments.scene);
  if (needsShippedBlobFile(file)) makeShippedBlobFile();
  return loadScene(file, overrides);
}

bool isText(std::string_view text) {
  while (!text.empty()) {
    const Utf8Character first = firstCharacter(text);
    if (first.bytes == 0 || first.code < 0x20) return false;
    text.remove_prefix(first.bytes);
  }
  return true;
}

// It stands in the file, in quotes and as part of other names.
void refuseStem(const std::string& stem) {
  if (stem.find_first_of("\"<>&\\") != std::string::npos || stem.find("--") != std::string::npos ||
      !isText(stem))
    throw UsageError(
        fmt::format("--output {}: in the file's name no quotes, < > & \\, -- and control "
                    "characters are allowed, and it must be UTF-8.",
                    printable(stem)));
}

fs::path outputOf(const ExportArguments& arguments, const LoadedScene& scene, ExportFormat format) {
  const char* ending = format == ExportFormat::kPbrt ? ".pbrt" : ".xml";
  if (arguments.output.empty()) return scene.name + ending;
  if (fs::path(arguments.output).extension() != ending)
    throw UsageError(fmt::format("--output {}: a file for {} ends in {}.", arguments.output,
                                 arguments.format, ending));
  return arguments.output;
}

// In the folder of the scene file. Of Mitsuba's variants it is the fastest on processors.
std::string renderCommand(ExportFormat format, const std::string& stem) {
  return format == ExportFormat::kPbrt ? "pbrt " + shellWord(stem + ".pbrt")
                                       : "mitsuba -m llvm_ad_rgb " + shellWord(stem + ".xml");
}

void sayHowToGoOn(const ExportArguments& arguments, const fs::path& output, ExportFormat format,
                  const std::string& command) {
  const bool pbrt = format == ExportFormat::kPbrt;
  fmt::print("\nIn its folder:\n  {}\n", command);
  if (!pbrt)
    fmt::print("The variant llvm_ad_rgb needs LLVM; where there is none: -m scalar_rgb, slower.\n");
  fmt::print(
      "Then, with the CPU seconds that it took:\n  ./pathmark bench error {}{}{} --peer {}={},"
      "SECONDS\n",
      shellWord(arguments.scene),
      arguments.size.empty() ? "" : fmt::format(" --size {}", shellWord(arguments.size)),
      arguments.maxBounces < 0 ? "" : fmt::format(" --max-bounces {}", arguments.maxBounces),
      pbrt ? "pbrt" : "Mitsuba",
      shellWord(displayPath(fs::path(output).replace_extension(".exr"))));
}

int exportScene(const ExportArguments& arguments) {
  const ExportFormat format = findFormat(arguments.format);
  const LoadedScene loaded = load(arguments);
  const WorldScene scene = worldScene(loaded);
  requireFloats(scene);
  const fs::path output = outputOf(arguments, loaded, format);
  requirePlaceForFile("--output", output);
  const ExportRequest request{
      output.stem().string(),
      static_cast<std::uint64_t>(arguments.raysPerPixel > 0 ? arguments.raysPerPixel
                                                            : loaded.raysPerPixel),
      renderCommand(format, output.stem().string())};
  refuseStem(request.stem);
  const std::vector<ExportedFile> files =
      format == ExportFormat::kPbrt ? exportPbrt(scene, request) : exportMitsuba(scene, request);
  // The scene last: it is there only when its meshes are.
  for (const ExportedFile& file : std::views::reverse(files)) {
    const fs::path path = output.parent_path() / file.path;
    if (path.has_parent_path()) fs::create_directories(path.parent_path());
    writeFileAtomically(path, file.content);
  }
  fmt::print("Wrote {}{}.\n", displayPath(output),
             files.size() > 1 ? fmt::format(" and, in {}_meshes/, {} {}", request.stem,
                                            files.size() - 1, files.size() == 2 ? "mesh" : "meshes")
                              : "");
  for (const std::string& note : exportNotes(scene, format)) fmt::print("Note: {}\n", note);
  sayHowToGoOn(arguments, output, format, request.command);
  return kSuccess;
}

}  // namespace

void addExportCommand(CLI::App& app, CommandAction& action) {
  const auto arguments = std::make_shared<ExportArguments>();
  CLI::App* command = app.add_subcommand("export", "Write a scene for pbrt-v4 or Mitsuba 3");
  command
      ->add_option("SCENE", arguments->scene,
                   "A scene's name in scenes/ or student/scenes/, or a .json file")
      ->required()
      ->type_name("");
  command->add_option("--format", arguments->format, "pbrt or mitsuba")
      ->required()
      ->type_name("FORMAT");
  command
      ->add_option("--output", arguments->output,
                   "The file to write, .pbrt or .xml; meshes go into a folder beside it (default: "
                   "SCENE.pbrt or SCENE.xml)")
      ->type_name("FILE");
  takesWholeNumber(command->add_option("--rays-per-pixel", arguments->raysPerPixel,
                                       "Rays through each pixel (default: the scene's)"),
                   1, kMostRaysPerPixel);
  command->add_option("--size", arguments->size, "Width x height, such as 640x480")
      ->type_name("WxH");
  takesWholeNumber(command->add_option("--max-bounces", arguments->maxBounces,
                                       "Scattering events on a path (default: the scene's)"),
                   0, 1000);
  command->footer(
      "Examples:\n"
      "  ./pathmark export cornell_box --format mitsuba\n"
      "  ./pathmark export cornell_box --format pbrt --rays-per-pixel 256 --output "
      "/tmp/box.pbrt\n\n"
      "Camera, film, box filter, length of paths, geometry, Lambertian materials and lights that\n"
      "shine from their front are the same there; a scene that is far from the origin for its "
      "size\n"
      "is moved there as a whole. This, and what the other renderer has no counterpart of, is "
      "said\n"
      "here and at the top of the file; handouts/error.md tells more.\n"
      "Exit code: 0 done, 2 the command line or the scene is at fault, 3 the machine is.");
  command->callback(
      [arguments, &action] { action = [arguments] { return exportScene(*arguments); }; });
}

}  // namespace pathmark
