// The one rounding from double to float, and back.
#pragma once

#include "scene/flat_scene.h"

#include <glm/glm.hpp>

namespace pathmark {

// Not inline: GCC 12 with ThreadSanitizer leaves the rounding out where it sees both conversions.
Float3 toFloat3(const glm::dvec3& v);

inline glm::dvec3 toDouble3(const Float3& v) { return {v[0], v[1], v[2]}; }

}  // namespace pathmark
