// Rays as a path tracer makes them: diffuse bounces of a scene.
//
//   RaySet        rays prepared beforehand, so that only intersection is measured
//   prepareRays   makes them
//   surfaceAt     where a ray has met the scene
#pragma once

#include "bench/ray_scenes.h"
#include "intersect/primitive_hit.h"

#include <cstddef>
#include <vector>

namespace pathmark::bench {

// As many rays as what they meet needs to drive each other out of the caches: a render's rays never
// come again, and measured with some that do, a large hierarchy seems up to four times as fast.
struct RaySet {
  static constexpr std::size_t kStarts = std::size_t{1} << 12;

  std::vector<Ray> rays;         // independent of each other, each from a vertex of some path
  std::vector<Vector> segments;  // from the same origins to the lamp
  std::vector<Ray> starts;       // from points of the surface, for chains
};

RaySet prepareRays(const RayScene& scene);

struct Surface {
  Point p;
  Vector n;  // unit, on the side that the ray comes from
};

inline Surface surfaceAt(const FlatSceneView& scene, const Ray& ray, const PrimitiveHit& hit) {
  const Point p = ray.origin + hit.t * ray.direction;
  Vector n;
  if (hit.isSphere) {
    const FlatSphere& s = scene.spheres[hit.index];
    n = (p - Point(s.centre[0], s.centre[1], s.centre[2])) / s.radius;
  } else {
    const Float3& normal = scene.triangles[hit.index].normal;
    n = {normal[0], normal[1], normal[2]};
  }
  return {p, dot(n, ray.direction) > 0.0f ? -n : n};
}

// Where a ray starts that leaves a surface of the scene.
inline Point leave(const Surface& surface, const RayScene& scene) {
  return surface.p + scene.offset * surface.n;
}

}  // namespace pathmark::bench
