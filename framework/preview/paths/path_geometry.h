// From paths to lines on the picture.
#pragma once

#include "preview/projection.h"

#include <glm/glm.hpp>

#include <optional>

namespace pathmark::preview {

// What one pixel of the picture covers, as a length at the point's distance; 0 behind the camera.
double pixelSizeAt(const FlatCamera& camera, const glm::dvec3& point);

// The part of a segment that lies on the picture, with `margin` pixels around it; nothing if there
// is none, or if it is not finite.
std::optional<ProjectedSegment> clip(const ProjectedSegment& segment, const FlatCamera& camera,
                                     double margin);

}  // namespace pathmark::preview
