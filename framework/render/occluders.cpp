#include "render/occluders.h"

#include "math/rounding.h"

#include <algorithm>
#include <numeric>

namespace pathmark {

namespace {

using Vector3 = glm::dvec3;

Vector3 toVector3(const Float3& a) { return {a[0], a[1], a[2]}; }

double radiusOf(const FlatSphere& sphere) { return static_cast<double>(sphere.radius); }

// How far a point of a surface may lie off it: as far as rays are moved off it.
double tolerance(const FlatSceneView& scene) {
  float magnitude = 0.0f;
  for (const FlatTriangle& t : scene.triangles)
    for (const Float3& corner : scene.corners(t))
      magnitude = std::max(magnitude, largestComponent({corner[0], corner[1], corner[2]}));
  for (const FlatSphere& s : scene.spheres)
    magnitude =
        std::max(magnitude, largestComponent({s.centre[0], s.centre[1], s.centre[2]}) + s.radius);
  return static_cast<double>(offsetForMagnitude(magnitude));
}

// The interval of heights above a plane that the whole scene lies in.
struct Heights {
  double least = 0.0, most = 0.0;

  void add(double low, double high) {
    least = std::min(least, low);
    most = std::max(most, high);
  }
};

bool boundsScene(const FlatSceneView& scene, const FlatTriangle& triangle, double tolerance) {
  const auto corners = scene.corners(triangle);
  const Vector3 a = toVector3(corners[0]);
  const Vector3 n =
      glm::normalize(glm::cross(toVector3(corners[1]) - a, toVector3(corners[2]) - a));
  Heights heights;
  for (const FlatTriangle& other : scene.triangles)
    for (const Float3& corner : scene.corners(other)) {
      const double height = glm::dot(toVector3(corner) - a, n);
      heights.add(height, height);
    }
  for (const FlatSphere& sphere : scene.spheres) {
    const double height = glm::dot(toVector3(sphere.centre) - a, n);
    heights.add(height - radiusOf(sphere), height + radiusOf(sphere));
  }
  // A lamp whose back is turned to the scene hides itself from whoever forgets its cosine.
  const bool shines = scene.shapes[triangle.shape].emission != Float3{};
  return heights.least >= -tolerance || (!shines && heights.most <= tolerance);
}

bool surroundsScene(const FlatSceneView& scene, const FlatSphere& sphere, double tolerance) {
  const Vector3 centre = toVector3(sphere.centre);
  const double reach = radiusOf(sphere) + tolerance;
  const auto within = [&](const Float3& p) { return glm::distance(toVector3(p), centre) <= reach; };
  return std::all_of(scene.triangles.begin(), scene.triangles.end(),
                     [&](const FlatTriangle& t) {
                       const auto corners = scene.corners(t);
                       return std::all_of(corners.begin(), corners.end(), within);
                     }) &&
         std::all_of(scene.spheres.begin(), scene.spheres.end(), [&](const FlatSphere& other) {
           return glm::distance(toVector3(other.centre), centre) + radiusOf(other) <= reach;
         });
}

template <class Primitive, class CanOcclude>
std::vector<std::uint32_t> indicesOf(std::span<const Primitive> primitives, CanOcclude can) {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < primitives.size(); ++i)
    if (can(primitives[i])) indices.push_back(i);
  return indices;
}

}  // namespace

Occluders occludersOf(const FlatSceneView& scene) {
  const double off = tolerance(scene);
  return {indicesOf(scene.triangles,
                    [&](const FlatTriangle& t) { return !boundsScene(scene, t, off); }),
          indicesOf(scene.spheres,
                    [&](const FlatSphere& s) { return !surroundsScene(scene, s, off); })};
}

Occluders allPrimitives(const FlatSceneView& scene) {
  Occluders all{std::vector<std::uint32_t>(scene.triangles.size()),
                std::vector<std::uint32_t>(scene.spheres.size())};
  std::iota(all.triangles.begin(), all.triangles.end(), 0u);
  std::iota(all.spheres.begin(), all.spheres.end(), 0u);
  return all;
}

}  // namespace pathmark
