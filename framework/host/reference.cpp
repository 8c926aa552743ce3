#include "host/reference.h"

#include "host/build_config.h"
#include "host/content_hash.h"

namespace pathmark {

namespace fs = std::filesystem;

fs::path referenceFile(const std::string& scene) {
  return fs::path(build::kProjectFolder) / "scenes/references" / (scene + ".exr");
}

std::optional<ImageFile> readReference(const LoadedScene& scene) {
  const fs::path file = referenceFile(scene.name);
  if (!fs::exists(file)) return std::nullopt;
  ImageFile reference = readImage(file);
  const FlatCamera& camera = scene.flat.camera;
  const bool fits = reference.origin.sceneHash == contentHash(packScene(scene.flat)) &&
                    reference.image.width == static_cast<int>(camera.width) &&
                    reference.image.height == static_cast<int>(camera.height);
  if (!fits) return std::nullopt;
  return reference;
}

}  // namespace pathmark
