// noteLightsInPlanes: lights that lie in the plane of another shape, and overlap it.
//
// Of two surfaces at the same place, rounding decides which one a ray meets. Points on such a light
// are sampled all the same, so that estimators that sample it and ones that meet it by chance
// differ.
#pragma once

#include "scene/flat_scene.h"

#include <string>
#include <vector>

namespace pathmark {

// Adds a sentence to `notes` if there is such a light. Of surfaces that look the same way only: the
// bottom of a box that stands on a lamp hides nothing that is seen. Large meshes and scenes with
// very many shapes are not looked through to their end.
void noteLightsInPlanes(const FlatScene& scene, std::vector<std::string>& notes);

}  // namespace pathmark
