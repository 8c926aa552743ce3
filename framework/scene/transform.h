// transform: where a box or a mesh is put.
//
//   placed     the point after scaling, then rotating, then moving
//   mirrors    whether that turns insides out
#pragma once

#include "scene/description.h"

#include <glm/glm.hpp>

namespace pathmark {

// The matrix of scaling and rotating (Rodrigues' formula for the latter), in double.
glm::dmat3 linearPart(const TransformDescription& transform);

inline glm::dvec3 placed(const glm::dmat3& linear, const TransformDescription& transform,
                         const glm::dvec3& point) {
  return linear * point + transform.translate;
}

// A mirrored triangle runs the other way round, so its vertices must be turned.
inline bool mirrors(const TransformDescription& transform) {
  const glm::dvec3& s = transform.scale;
  return ((s.x < 0.0) != (s.y < 0.0)) != (s.z < 0.0);
}

}  // namespace pathmark
