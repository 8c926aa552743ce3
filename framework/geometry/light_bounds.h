// Where a light of faces is.
#pragma once

#include <pathmark/lit_scene.h>

#include <span>

namespace pathmark {

// Around the box of all vertices; no point of a face lies outside, also if it is rounded.
Sphere sphereAround(std::span<const Light::Face> faces);

}  // namespace pathmark
