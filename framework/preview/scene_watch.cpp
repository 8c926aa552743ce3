#include "preview/scene_watch.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <system_error>

namespace pathmark::preview {

namespace fs = std::filesystem;

namespace {

std::string stampOfFile(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error).time_since_epoch().count();
  return fmt::format("{} {} {}", file.string(), error ? 0 : time, fs::file_size(file, error));
}

// Of a scene that is not right yet, those that can be told.
std::vector<fs::path> meshFilesOf(const fs::path& scene) {
  std::ifstream in(scene);
  const nlohmann::json json = nlohmann::json::parse(in, nullptr, false, true);
  std::vector<fs::path> files;
  if (!json.is_object()) return files;
  const auto shapes = json.find("shapes");
  if (shapes == json.end() || !shapes->is_array()) return files;
  for (const nlohmann::json& shape : *shapes) {
    if (!shape.is_object()) continue;
    const auto file = shape.find("file");
    if (file != shape.end() && file->is_string())
      files.push_back(scene.parent_path() / file->get<std::string>());
  }
  return files;
}

}  // namespace

std::string SceneWatch::stampOf(const fs::path& scene) {
  std::string stamp = stampOfFile(scene);
  if (stamp != own_) {
    own_ = stamp;
    meshes_ = meshFilesOf(scene);
  }
  for (const fs::path& mesh : meshes_) stamp += "\n" + stampOfFile(mesh);
  return stamp;
}

}  // namespace pathmark::preview
