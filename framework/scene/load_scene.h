// loadScene: a scene file, checked, normalised and flattened for a worker.
//
//   LoadedScene   what a render needs to know of a scene
//   SceneError    a sentence for a person: file, line, JSON pointer, what was found and is allowed
#pragma once

#include "scene/flat_scene.h"
#include "scene/source.h"

#include <array>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace pathmark {

class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Maps the scene file's coordinates to the worker's: normalised = scale * (file - shift).
struct Normalisation {
  std::array<double, 3> shift{0.0, 0.0, 0.0};
  double scale = 1.0;  // a power of two
};

struct LoadedScene {
  FlatScene flat;
  Normalisation normalisation;
  std::string name;                // the file's name without folder and ending
  std::string caption;             // may be empty
  std::array<double, 3> target{};  // that the camera looks at, in normalised coordinates
  std::array<double, 3> up{};      // the camera's, unit length
  double exposure = 1.0;           // factor on linear radiance for display only
  int raysPerPixel = 64;           // default for renders
  std::vector<std::string> notes;  // sentences about what was dropped or changed while loading
};

// What the command line may say instead of the scene file.
struct SceneOverrides {
  std::optional<std::array<int, 2>> size{};  // width, height; the vertical field of view stays
  std::optional<int> maxBounces{};
};

// Throws SceneError.
LoadedScene loadScene(const std::filesystem::path& file, const SceneOverrides& overrides = {});

// The same of a text that need not be in the file; meshes are looked for in the file's folder.
LoadedScene loadScene(const SceneSource& source, const SceneOverrides& overrides = {});

}  // namespace pathmark
