#include "export/export_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark {

namespace {

// Squares of lengths, and the product of both clipping distances, are floats then.
constexpr double kShortest = 1e-14, kLongest = 1e18;

// With room for the tangent of its half, and for pbrt's field of view of a film's shorter side.
constexpr double kNarrowest = 1e-25, kWidest = 179.99;

double largestCoordinate(const WorldScene& scene) {
  double largest = 0.0;
  const auto include = [&](const glm::dvec3& p) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  };
  include(scene.camera.eye);
  include(scene.camera.target);
  for (const WorldMesh& mesh : scene.meshes)
    for (const glm::dvec3& vertex : mesh.vertices) include(vertex);
  for (const WorldSphere& sphere : scene.spheres) include(glm::abs(sphere.centre) + sphere.radius);
  return largest;
}

[[noreturn]] void refuse(const WorldScene& scene, const std::string& found,
                         const std::string& rule) {
  throw SceneError(fmt::format("{}: found {}, but pbrt and Mitsuba compute in float: {}.",
                               scene.name, found, rule));
}

}  // namespace

double farthestSurface(const WorldScene& scene) {
  const glm::dvec3& eye = scene.camera.eye;
  double farthest = 0.0;
  for (const WorldMesh& mesh : scene.meshes)
    for (const glm::dvec3& vertex : mesh.vertices)
      farthest = std::max(farthest, glm::distance(eye, vertex));
  for (const WorldSphere& sphere : scene.spheres)
    farthest = std::max(farthest, glm::distance(eye, sphere.centre) + sphere.radius);
  return farthest;
}

void requireFloats(const WorldScene& scene) {
  const double coordinate = largestCoordinate(scene), farthest = farthestSurface(scene);
  if (!(coordinate <= kLongest))
    refuse(scene, fmt::format("a coordinate of size {:.3g}", coordinate),
           fmt::format("one may have at most {}", kLongest));
  if (!(farthest >= kShortest))
    refuse(scene, fmt::format("no surface farther than {:.3g} from the eye", farthest),
           fmt::format("the farthest must have a distance of at least {}", kShortest));
  const double angle = scene.camera.fieldOfView;
  if (!(angle >= kNarrowest && angle <= kWidest))
    refuse(scene, fmt::format("a vertical field of view of {:.10g} degrees", angle),
           fmt::format("it must be from {} to {}", kNarrowest, kWidest));
}

}  // namespace pathmark
