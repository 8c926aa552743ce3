// pathmark mesh: meshes that are made rather than shipped.
#include "host/blob_file.h"
#include "host/commands.h"
#include "host/display_path.h"
#include "host/exit_code.h"
#include "host/options.h"
#include "host/output_file.h"
#include "host/session.h"
#include "scene/blob_mesh.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

struct MeshArguments {
  std::string name;
  int subdivisions = kBlobSubdivisions;
  std::string output;
};

int mesh(const MeshArguments& arguments) {
  if (arguments.name != "blob")
    throw UsageError(fmt::format("There is no mesh {}: blob is the only one.", arguments.name));
  const fs::path file = arguments.output.empty() ? shippedBlobFile() : fs::path(arguments.output);
  if (arguments.output.empty()) fs::create_directories(file.parent_path());
  requirePlaceForFile("--output", file);
  const auto started = std::chrono::steady_clock::now();
  const std::size_t triangles = writeBlobFile(file, arguments.subdivisions);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - started;
  fmt::print("{}: {} triangles, {:.2f} s\n", displayPath(file), triangles, seconds.count());
  return kSuccess;
}

}  // namespace

void addMeshCommand(CLI::App& app, CommandAction& action) {
  const auto arguments = std::make_shared<MeshArguments>();
  CLI::App* command =
      app.add_subcommand("mesh", "Make a mesh of many triangles, such as the scene blob's");
  command->add_option("MESH", arguments->name, "The mesh to make: blob")->required()->type_name("");
  takesWholeNumber(
      command->add_option("--subdivisions", arguments->subdivisions,
                          "Parts of each edge of the octahedron that becomes the blob: n make "
                          "8 n^2 triangles (default: 354)"),
      1, 2000);
  command
      ->add_option("--output", arguments->output,
                   "The OBJ file to write (default: scenes/meshes/blob.obj)")
      ->type_name("FILE");
  command->footer(
      "Examples:\n"
      "  ./pathmark mesh blob                     (40 MB, which the scene blob needs)\n"
      "  ./pathmark mesh blob --subdivisions 20 --output student/scenes/coarse.obj");
  command->callback([arguments, &action] { action = [arguments] { return mesh(*arguments); }; });
}

}  // namespace pathmark
