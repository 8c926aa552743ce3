// SceneWatch: sees when a scene's file, or a file of its meshes, is saved.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pathmark::preview {

class SceneWatch {
 public:
  // Another text after each save, and for each scene.
  std::string stampOf(const std::filesystem::path& scene);

 private:
  std::string own_;  // of the scene's file alone, from which the meshes were read
  std::vector<std::filesystem::path> meshes_;
};

}  // namespace pathmark::preview
