// normalise: moves a scene into coordinates in which float is accurate.
//
//   chooseNormalisation   what to do with a scene
//   normalise             does it, in double
//
// Judged by the bounding box of all geometry and the eye. A box whose half extent (half its longest
// side) lies in [1e-2, 1e4] keeps its scale; otherwise a power of two, which rounds nothing, brings
// the half extent into [1, 2). A box whose centre is within four half extents of the origin, along
// each axis, is not moved; otherwise its centre becomes the origin. Most scenes need neither, and
// keep the coordinates of their file.
#pragma once

#include "scene/description.h"
#include "scene/load_scene.h"

#include <glm/glm.hpp>

namespace pathmark {

Normalisation chooseNormalisation(const SceneDescription& scene);

bool isIdentity(const Normalisation& normalisation);

// A point and a length of the file in normalised coordinates.
glm::dvec3 normalisedPoint(const Normalisation& normalisation, const glm::dvec3& point);
double normalisedLength(const Normalisation& normalisation, double length);

// The eye, all vertices and all spheres; the target only gives a direction and stays as it is.
void normalise(SceneDescription& scene, const Normalisation& normalisation);

}  // namespace pathmark
