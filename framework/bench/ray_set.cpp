#include "bench/ray_set.h"

#include "bench/random_direction.h"
#include "intersect/embree_intersector.h"
#include "intersect/flat_intersector.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace pathmark::bench {

namespace {

constexpr int kMostBounces = 8;
constexpr std::size_t kFewestRays = std::size_t{1} << 16, kRaysOfTriangle = 2;

Vector toVector(const Float3& a) { return {a[0], a[1], a[2]}; }

Ray diffuseBounce(const Surface& surface, const RayScene& scene, QuickRandom& random) {
  const Vector direction = surface.n + 0.9999f * randomDirection(random);
  return {leave(surface, scene), normalize(direction)};
}

// Chooses points of a scene's front sides by area.
class SurfacePoints {
 public:
  explicit SurfacePoints(const FlatSceneView& scene) : scene_(scene) {
    double sum = 0.0;
    for (const FlatTriangle& t : scene.triangles) {
      const auto corners = scene.corners(t);
      const Point a = toVector(corners[0]);
      sum += 0.5 * length(cross(toVector(corners[1]) - a, toVector(corners[2]) - a));
      cumulative_.push_back(sum);
    }
    for (const FlatSphere& s : scene.spheres) {
      sum += 4.0 * kPi * s.radius * s.radius;
      cumulative_.push_back(sum);
    }
  }

  Surface choose(QuickRandom& random) const {
    const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1,
                                        random.next() * cumulative_.back());
    const auto index = static_cast<std::size_t>(found - cumulative_.begin());
    const std::size_t triangles = scene_.triangles.size();
    return index < triangles ? onTriangle(scene_.triangles[index], random)
                             : onSphere(scene_.spheres[index - triangles], random);
  }

 private:
  Surface onTriangle(const FlatTriangle& triangle, QuickRandom& random) const {
    const auto corners = scene_.corners(triangle);
    const float root = std::sqrt(random.next()), t = random.next();
    return {(1.0f - root) * toVector(corners[0]) + root * (1.0f - t) * toVector(corners[1]) +
                root * t * toVector(corners[2]),
            toVector(triangle.normal)};
  }

  static Surface onSphere(const FlatSphere& sphere, QuickRandom& random) {
    const Vector outward = randomDirection(random);
    return {toVector(sphere.centre) + sphere.radius * outward,
            sphere.inward != 0 ? -outward : outward};
  }

  FlatSceneView scene_;
  std::vector<double> cumulative_;  // area of the primitives up to each, triangles first
};

using Closest = std::function<bool(const Ray&, PrimitiveHit&)>;

// A point that the camera sees, in a pixel by chance.
Surface chooseSeen(const FlatCamera& camera, const FlatSceneView& view, const Closest& closest,
                   QuickRandom& random) {
  while (true) {
    const float x = random.next() * static_cast<float>(camera.width),
                y = random.next() * static_cast<float>(camera.height);
    const Ray ray{toVector(camera.eye),
                  normalize(toVector(camera.topLeft) + x * toVector(camera.pixelRight) +
                            y * toVector(camera.pixelDown))};
    PrimitiveHit hit;
    if (closest(ray, hit)) return surfaceAt(view, ray, hit);
  }
}

void addPath(const RayScene& scene, const FlatSceneView& view, const Closest& closest, Ray ray,
             QuickRandom& random, std::size_t rays, RaySet& set) {
  for (int bounce = 0; bounce < kMostBounces && set.rays.size() < rays; ++bounce) {
    set.rays.push_back(ray);
    const Point onLamp =
        scene.lamp.corner + random.next() * scene.lamp.side + random.next() * scene.lamp.otherSide;
    // Ends before the lamp, which may lie on a surface.
    set.segments.push_back(0.999f * (onLamp - ray.origin));
    PrimitiveHit hit;
    if (!closest(ray, hit)) return;
    ray = diffuseBounce(surfaceAt(view, ray, hit), scene, random);
  }
}

}  // namespace

RaySet prepareRays(const RayScene& scene) {
  const FlatSceneView view = viewOf(scene.flat);
  const SurfacePoints points(view);
  QuickRandom random(view.triangles.size() + view.spheres.size());
  const std::size_t rays = std::max(kFewestRays, kRaysOfTriangle * view.triangles.size());
  RaySet set;
  set.rays.reserve(rays);
  set.segments.reserve(rays);
  const auto makeAll = [&](const Closest& closest) {
    const auto start = [&] {
      const Surface from =
          scene.camera ? chooseSeen(*scene.camera, view, closest, random) : points.choose(random);
      return diffuseBounce(from, scene, random);
    };
    while (set.rays.size() < rays) addPath(scene, view, closest, start(), random, rays, set);
    while (set.starts.size() < RaySet::kStarts) set.starts.push_back(start());
  };
  if (view.spheres.empty()) {
    const EmbreeIntersector embree(view);
    makeAll([&](const Ray& ray, PrimitiveHit& hit) {
      return embree.closest(ray, std::numeric_limits<float>::infinity(), hit);
    });
  } else {
    const FlatIntersector flat(view);
    makeAll([&](const Ray& ray, PrimitiveHit& hit) { return flat.closest(ray, hit); });
  }
  // Neighbours in the array then belong to different paths.
  for (std::size_t i = set.rays.size() - 1; i > 0; --i) {
    const std::size_t other = random.bits() % (i + 1);
    std::swap(set.rays[i], set.rays[other]);
    std::swap(set.segments[i], set.segments[other]);
  }
  return set;
}

}  // namespace pathmark::bench
