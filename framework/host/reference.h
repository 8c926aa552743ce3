// The reference images of the shipped scenes, which pictures are compared with.
//
//   referenceFile   where one is
//   fits            whether an image is of a scene
//   readReference   a reference that fits its scene
#pragma once

#include "film/image_file.h"
#include "scene/load_scene.h"

#include <filesystem>
#include <optional>
#include <string>

namespace pathmark {

// scenes/references/NAME.exr
std::filesystem::path referenceFile(const std::string& scene);

// Whether the image is of this version of the scene, in its size.
bool fits(const ImageFile& image, const LoadedScene& scene);

// Nothing if there is none, or it is of another version of the scene or of another size. Throws
// ImageError if it cannot be read.
std::optional<ImageFile> readReference(const LoadedScene& scene);

}  // namespace pathmark
