// What a scene must have for a picture to show anything.
//
//   requireView    a camera that can see
//   noteDarkness   a light
#pragma once

#include "scene/flat_scene.h"
#include "scene/place.h"

#include <string>
#include <vector>

namespace pathmark {

// Throws SceneError if there are shapes and all of them are wholly outside of the pyramid that the
// image sees: to a side of it, or behind the eye.
void requireView(const FlatScene& scene, const Place& camera);

// Adds a sentence to `notes` if there is nothing to see, or nothing that shines.
void noteDarkness(const FlatScene& scene, std::vector<std::string>& notes);

}  // namespace pathmark
