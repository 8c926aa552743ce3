// Rays that leave a surface: their origins are moved to the side that they leave to.
#include "math/rounding.h"

#include <pathmark/lit_scene.h>
#include <pathmark/warmup.h>

namespace pathmark {

Ray Hit::spawnRay(const Vector& wi) const {
  return {p + (dot(wi, n) < 0.0f ? -error : error) * n, wi};
}

// The point was computed as origin + t * direction, so that its error is bounded by the largest
// coordinate around and not by the triangle's own; the triangle's extent stands for that.
Ray spawn_ray(const vec3& point, const Triangle& triangle, const vec3& direction) {
  float magnitude = largestComponent(point);
  for (const vec3& corner : triangle.positions)
    magnitude = std::max(magnitude, largestComponent(corner));
  constexpr float kRayPointFactor = 8.0f;
  const float offset = kRayPointFactor * offsetForMagnitude(magnitude);
  const float side = dot(direction, triangle.normal) < 0.0f ? -1.0f : 1.0f;
  return {point + side * offset * triangle.normal, direction};
}

}  // namespace pathmark
