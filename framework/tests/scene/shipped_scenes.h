// The scenes of scenes/, and what tests ask of them.
//
//   sceneFiles, loadShipped, shipped   the files; one of them, by path or by name
//   areaOf, powerOf                    of a light
#pragma once

#include "scene/blob_mesh.h"
#include "scene/encode_obj.h"
#include "scene/load_scene.h"

#include <fmt/format.h>
#include <unistd.h>
#include <glm/glm.hpp>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace pathmark {

inline const std::filesystem::path kRoot = PATHMARK_ROOT;

inline std::vector<std::filesystem::path> sceneFiles(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path& file = entry.path();
    if (file.extension() == ".json" && file.stem().extension() != ".schema") files.push_back(file);
  }
  return files;
}

// The scene blob needs a mesh that is made, not shipped: it is loaded from a copy with a coarse
// one.
class BlobFolder {
 public:
  BlobFolder()
      : path_(std::filesystem::temp_directory_path() / fmt::format("pathmark-blob-{}", getpid())) {
    std::filesystem::create_directories(path_ / "meshes");
    std::filesystem::copy(kRoot / "scenes" / "blob.json", path_ / "blob.json");
    std::ofstream(path_ / "meshes" / "blob.obj") << encodeObj(makeBlobMesh(kSubdivisions));
  }
  ~BlobFolder() { std::filesystem::remove_all(path_); }
  BlobFolder(const BlobFolder&) = delete;
  BlobFolder& operator=(const BlobFolder&) = delete;

  static constexpr int kSubdivisions = 20;
  std::filesystem::path scene() const { return path_ / "blob.json"; }

 private:
  std::filesystem::path path_;
};

inline LoadedScene loadShipped(const std::filesystem::path& file) {
  return file.stem() == "blob" ? loadScene(BlobFolder().scene()) : loadScene(file);
}

inline LoadedScene shipped(const std::string& name) {
  return loadShipped(kRoot / "scenes" / (name + ".json"));
}

inline glm::dvec3 toDouble(const Float3& v) { return {v[0], v[1], v[2]}; }

inline double areaOf(const FlatScene& scene, const FlatLight& light) {
  double area = 0.0;
  if (light.sphere != FlatLight::kNoSphere) {
    const double radius = scene.spheres[light.sphere].radius;
    return 4.0 * std::numbers::pi * radius * radius;
  }
  for (std::uint32_t f = light.firstFace; f < light.firstFace + light.faceCount; ++f) {
    const FlatFace& face = scene.faces[f];
    const auto vertex = [&](std::uint32_t k) {
      return toDouble(scene.lightVertices[face.firstVertex + k]);
    };
    for (std::uint32_t t = 0; t < face.triangleCount; ++t) {
      const auto [a, b, c] = scene.lightTriangles[face.firstTriangle + t];
      area += 0.5 * glm::length(glm::cross(vertex(b) - vertex(a), vertex(c) - vertex(a)));
    }
  }
  return area;
}

// Of all channels together: pi times area times radiance.
inline double powerOf(const FlatScene& scene, const FlatLight& light) {
  return std::numbers::pi * areaOf(scene, light) *
         (light.emission[0] + light.emission[1] + light.emission[2]);
}

}  // namespace pathmark
