#include "preview/projection.h"

#include <algorithm>
#include <cmath>

namespace pathmark::preview {

namespace {

glm::dvec3 vec(const Float3& v) { return {v[0], v[1], v[2]}; }

// A point as topLeft + x pixelRight + y pixelDown, scaled by its depth: (x depth, y depth, depth).
glm::dvec3 inFilmCoordinates(const FlatCamera& camera, const glm::dvec3& point) {
  const glm::dmat3 axes(vec(camera.pixelRight), vec(camera.pixelDown), vec(camera.topLeft));
  return glm::inverse(axes) * (point - vec(camera.eye));
}

// Of the distance to the film: nearer points are at the eye itself.
constexpr double kNearest = 1e-4;

}  // namespace

std::optional<glm::dvec2> project(const FlatCamera& camera, const glm::dvec3& point) {
  const glm::dvec3 p = inFilmCoordinates(camera, point);
  if (p.z < kNearest) return std::nullopt;
  return glm::dvec2(p.x, p.y) / p.z;
}

std::optional<ProjectedSegment> project(const FlatCamera& camera, const glm::dvec3& from,
                                        const glm::dvec3& to) {
  glm::dvec3 a = inFilmCoordinates(camera, from), b = inFilmCoordinates(camera, to);
  if (a.z < kNearest && b.z < kNearest) return std::nullopt;
  const auto cut = [](const glm::dvec3& behind, const glm::dvec3& front) {
    return glm::mix(behind, front, (kNearest - behind.z) / (front.z - behind.z));
  };
  if (a.z < kNearest) a = cut(a, b);
  if (b.z < kNearest) b = cut(b, a);
  return ProjectedSegment{glm::dvec2(a.x, a.y) / a.z, glm::dvec2(b.x, b.y) / b.z};
}

}  // namespace pathmark::preview
