// The one rounding from double to float, and back.
#pragma once

#include "scene/flat_scene.h"

#include <glm/glm.hpp>

namespace pathmark {

inline Float3 toFloat3(const glm::dvec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

inline glm::dvec3 toDouble3(const Float3& v) { return {v[0], v[1], v[2]}; }

}  // namespace pathmark
