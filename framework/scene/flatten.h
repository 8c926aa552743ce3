// flatten: a checked and normalised scene as the arrays of a worker.
#pragma once

#include "scene/description.h"
#include "scene/flat_scene.h"
#include "scene/place.h"

#include <string>
#include <vector>

namespace pathmark {

// Everything but the film of the camera. Triangles that have no area once they are rounded to float
// are left out, and a sentence about them is added to `notes`. Throws SceneError if a shape that
// must have an area has none, or a sphere is too small beside the rest of the scene.
FlatScene flatten(const SceneDescription& scene, const Place& top, std::vector<std::string>& notes);

}  // namespace pathmark
