// Where on the film a camera ray goes through, in double.
#pragma once

#include <pathmark/camera.h>

#include <cmath>

namespace pathmark::checks {

// (x, y) with direction parallel to topLeft + x pixelRight + y pixelDown, in pixels.
inline glm::dvec2 filmPoint(const SimpleCamera& camera, const Vector& direction) {
  const glm::dmat3 system(glm::dvec3(camera.pixelRight()), glm::dvec3(camera.pixelDown()),
                          -glm::dvec3(direction));
  return glm::dvec2(glm::inverse(system) * -glm::dvec3(camera.topLeft()));
}

// What the rounding of a ray in float may shift its film point by, in pixels: eight roundoffs of
// the vectors that are added and normalised.
inline double filmTolerance(const SimpleCamera& camera, double x, double y) {
  const double right = glm::length(glm::dvec3(camera.pixelRight())),
               down = glm::length(glm::dvec3(camera.pixelDown())),
               corner = glm::length(glm::dvec3(camera.topLeft()));
  return 8 * 0x1p-24 * (corner + x * right + y * down) / std::min(right, down);
}

}  // namespace pathmark::checks
