#include "host/reference.h"

#include "host/build_config.h"
#include "host/session.h"

namespace pathmark {

namespace fs = std::filesystem;

fs::path referenceFile(const std::string& scene) {
  return fs::path(build::kProjectFolder) / "scenes/references" / (scene + ".exr");
}

bool fits(const ImageFile& image, const LoadedScene& scene) {
  const FlatCamera& camera = scene.flat.camera;
  return image.origin.sceneHash == sceneHash(scene) &&
         image.image.width == static_cast<int>(camera.width) &&
         image.image.height == static_cast<int>(camera.height);
}

std::optional<ImageFile> readReference(const LoadedScene& scene) {
  const fs::path file = referenceFile(scene.name);
  if (!fs::exists(file)) return std::nullopt;
  ImageFile reference = readImage(file);
  if (!fits(reference, scene)) return std::nullopt;
  return reference;
}

}  // namespace pathmark
