#include "scene/transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pathmark {

glm::dmat3 linearPart(const TransformDescription& transform) {
  const glm::dvec3& s = transform.scale;
  const glm::dmat3 scale(s.x, 0, 0, 0, s.y, 0, 0, 0, s.z);
  if (transform.angle == 0.0) return scale;
  // Whole turns first: the sine of a large angle in radians has lost its digits.
  const double radians = std::remainder(transform.angle, 360.0) * (std::numbers::pi / 180.0);
  const glm::dvec3 largest = glm::abs(transform.axis);
  const glm::dvec3 k = glm::normalize(transform.axis / std::max({largest.x, largest.y, largest.z}));
  const double sine = std::sin(radians), cosine = std::cos(radians);
  const glm::dmat3 cross(0, k.z, -k.y, -k.z, 0, k.x, k.y, -k.x, 0);
  const glm::dmat3 rotation =
      glm::dmat3(cosine) + sine * cross + (1.0 - cosine) * glm::outerProduct(k, k);
  return rotation * scale;
}

}  // namespace pathmark
