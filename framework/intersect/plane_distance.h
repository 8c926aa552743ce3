// Where a ray meets a triangle's plane, in double, for triangles too thin for float.
//
//   planeDistance   the distance along the ray, in lengths of its direction
//   isThin          whether an intersector's own distance is not to be trusted
//
// Intersectors interpolate the distance of a hit between those of the corners, by weights that are
// quotients of areas. For a triangle of length L and height h the weights are off by roundoff L/h,
// and so the distance by L times as much: for a thin triangle that is more than the offset by which
// rays leave a surface, and they would meet it again.
#pragma once

#include "scene/flat_scene.h"

#include <pathmark/types.h>

#include <algorithm>
#include <array>

namespace pathmark {

namespace detail {

inline glm::dvec3 edge(const Float3& from, const Float3& to) {
  return glm::dvec3(to[0], to[1], to[2]) - glm::dvec3(from[0], from[1], from[2]);
}

}  // namespace detail

inline double planeDistance(const std::array<Float3, 3>& corners, const Point& origin,
                            const Vector& direction) {
  const auto& [a, b, c] = corners;
  const glm::dvec3 n = glm::cross(detail::edge(a, b), detail::edge(a, c));
  const glm::dvec3 toPlane = glm::dvec3(a[0], a[1], a[2]) - glm::dvec3(origin);
  return glm::dot(n, toPlane) / glm::dot(n, glm::dvec3(direction));
}

// Less than a quarter as high as long. Rounding is covered many times by the offset of wider ones.
inline bool isThin(const std::array<Float3, 3>& corners) {
  constexpr double kLengthOverHeight = 4.0;
  const auto& [a, b, c] = corners;
  const glm::dvec3 ab = detail::edge(a, b), ac = detail::edge(a, c), bc = detail::edge(b, c);
  const double longest2 = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
  return longest2 > kLengthOverHeight * glm::length(glm::cross(ab, ac));
}

}  // namespace pathmark
