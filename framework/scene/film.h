// makeFilm: the camera's vectors from the eye to its film.
#pragma once

#include "scene/description.h"
#include "scene/flat_scene.h"
#include "scene/place.h"

#include <glm/glm.hpp>

namespace pathmark {

// Everything but FlatCamera::eye, from the camera in the coordinates of the file. The film stands
// at distance 1, or nearer for a field of view so wide that it would be larger than 2. Its x runs
// to the right as seen by the viewer, its y downwards; pixels are square. Throws SceneError if the
// camera looks along its up vector.
FlatCamera makeFilm(const CameraDescription& camera, int width, int height, const Place& place);

// Unit length, also where the square of the length is no double.
glm::dvec3 safeNormalize(const glm::dvec3& v);

// Whether neighbouring pixels of the film can be told apart in float.
bool isResolved(const FlatCamera& camera);

}  // namespace pathmark
