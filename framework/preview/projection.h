// From points of the scene to the picture.
#pragma once

#include "scene/flat_scene.h"

#include <glm/glm.hpp>

#include <optional>

namespace pathmark::preview {

// Column and row, in pixels from the top left corner, at which the camera sees the point; nothing
// for a point that is not in front of the camera.
std::optional<glm::dvec2> project(const FlatCamera& camera, const glm::dvec3& point);

// The part of the segment that is in front of the camera, projected; nothing if there is none.
struct ProjectedSegment {
  glm::dvec2 from, to;
};
std::optional<ProjectedSegment> project(const FlatCamera& camera, const glm::dvec3& from,
                                        const glm::dvec3& to);

}  // namespace pathmark::preview
