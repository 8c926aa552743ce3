#include "preview/paths/path_geometry.h"

#include <algorithm>
#include <cmath>

namespace pathmark::preview {

namespace {

glm::dvec3 vec(const Float3& v) { return {v[0], v[1], v[2]}; }

}  // namespace

double pixelSizeAt(const FlatCamera& camera, const glm::dvec3& point) {
  const glm::dvec3 right = vec(camera.pixelRight);
  const glm::dvec3 forward = glm::cross(right, vec(camera.pixelDown));
  const double depth =
      glm::dot(point - vec(camera.eye), forward) / glm::dot(vec(camera.topLeft), forward);
  return std::max(depth, 0.0) * glm::length(right);
}

// Liang & Barsky, "A New Concept and Method for Line Clipping", ACM TOG 3(1), 1984.
std::optional<ProjectedSegment> clip(const ProjectedSegment& segment, const FlatCamera& camera,
                                     double margin) {
  const glm::dvec2 way = segment.to - segment.from;
  if (!std::isfinite(way.x) || !std::isfinite(way.y)) return std::nullopt;
  const glm::dvec2 low(-margin), high(camera.width + margin, camera.height + margin);
  double enter = 0.0, leave = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    if (way[axis] == 0.0) {
      if (segment.from[axis] < low[axis] || segment.from[axis] > high[axis]) return std::nullopt;
      continue;
    }
    const double a = (low[axis] - segment.from[axis]) / way[axis];
    const double b = (high[axis] - segment.from[axis]) / way[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (enter > leave) return std::nullopt;
  return ProjectedSegment{segment.from + enter * way, segment.from + leave * way};
}

}  // namespace pathmark::preview
