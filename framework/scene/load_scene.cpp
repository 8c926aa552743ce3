#include "scene/load_scene.h"

#include "scene/film.h"
#include "scene/flatten.h"
#include "scene/light_planes.h"
#include "scene/normalise.h"
#include "scene/read_scene.h"
#include "scene/read_text.h"
#include "scene/shape_geometry.h"
#include "scene/validate.h"
#include "scene/view_check.h"

#include <fmt/format.h>

#include <cmath>
#include <new>

namespace pathmark {
namespace {

// For a person, who only knows the coordinates of the file.
std::string describe(const Normalisation& n) {
  return fmt::format(
      "Lengths are computed in units of 2^{} from the point ({:.6g}, {:.6g}, {:.6g}), because "
      "those of the file are too large, too small or too far from the origin for float.",
      -std::ilogb(n.scale), n.shift[0], n.shift[1], n.shift[2]);
}

LoadedScene load(const SceneSource& source, const SceneOverrides& overrides) {
  SceneDescription scene = readScene(source);
  applyOverrides(scene, overrides, source.file);
  validate(scene, source);
  makeGeometry(scene, source);

  LoadedScene loaded;
  loaded.name = source.file.stem().string();
  loaded.caption = scene.caption;
  loaded.exposure = scene.exposure;
  loaded.raysPerPixel = static_cast<int>(scene.raysPerPixel);

  // The film only has directions, so it needs no normalised coordinates.
  const Place top(source);
  FlatCamera camera = makeFilm(scene.camera, static_cast<int>(scene.size[0]),
                               static_cast<int>(scene.size[1]), Place(top, "camera"));
  if (!isResolved(camera)) {
    loaded.notes.emplace_back(
        "The field of view is so narrow for its number of pixels that their rays cannot be told "
        "apart in float.");
  }
  loaded.normalisation = chooseNormalisation(scene);
  if (!isIdentity(loaded.normalisation)) {
    normalise(scene, loaded.normalisation);
    loaded.notes.push_back(describe(loaded.normalisation));
  }
  loaded.flat = flatten(scene, top, loaded.notes);
  const glm::dvec3 target = normalisedPoint(loaded.normalisation, scene.camera.target);
  loaded.target = {target.x, target.y, target.z};
  const glm::dvec3 up = safeNormalize(scene.camera.up);
  loaded.up = {up.x, up.y, up.z};
  camera.eye = loaded.flat.camera.eye;
  loaded.flat.camera = camera;
  requireView(loaded.flat, Place(top, "camera"));
  noteDarkness(loaded.flat, loaded.notes);
  noteLightsInPlanes(loaded.flat, loaded.notes);
  return loaded;
}

}  // namespace

LoadedScene loadScene(const SceneSource& source, const SceneOverrides& overrides) {
  try {
    return load(source, overrides);
  } catch (const std::bad_alloc&) {
    throw SceneError(
        fmt::format("{}: the scene needs more memory than there is.", source.file.string()));
  }
}

LoadedScene loadScene(const std::filesystem::path& file, const SceneOverrides& overrides) {
  return loadScene(SceneSource{file, readText(file, "a scene is a JSON file")}, overrides);
}

}  // namespace pathmark
