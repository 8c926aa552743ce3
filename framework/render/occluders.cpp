#include "render/occluders.h"

#include "math/rounding.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pathmark {

namespace {

using Vector3 = glm::dvec3;

Vector3 toVector3(const Float3& a) { return {a[0], a[1], a[2]}; }

double radiusOf(const FlatSphere& sphere) { return static_cast<double>(sphere.radius); }

double largestOf(const Vector3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// How far a corner that is meant to lie in a plane may be off it: it is rounded itself, and so are
// the three that the plane goes through. `magnitude` is that of the largest coordinate of all.
double rounding(double magnitude) {
  constexpr double kRoundoffs = 8.0;
  return kRoundoffs * static_cast<double>(kUnitRoundoff) * magnitude;
}

double magnitudeOf(const FlatSceneView& scene, const FlatTriangle& triangle) {
  double magnitude = 0.0;
  for (const Float3& corner : scene.corners(triangle))
    magnitude = std::max(magnitude, largestOf(toVector3(corner)));
  return magnitude;
}

double magnitudeOf(const FlatSphere& sphere) {
  return largestOf(toVector3(sphere.centre)) + radiusOf(sphere);
}

// Whether the whole scene is above a plane, and whether it is below, but for rounding.
struct Sides {
  bool above = true, below = true;

  void add(double low, double high, double rounding) {
    above = above && low >= -rounding;
    below = below && high <= rounding;
  }
};

bool boundsScene(const FlatSceneView& scene, const FlatTriangle& triangle) {
  const auto corners = scene.corners(triangle);
  const double own = magnitudeOf(scene, triangle);
  const Vector3 a = toVector3(corners[0]);
  const Vector3 n =
      glm::normalize(glm::cross(toVector3(corners[1]) - a, toVector3(corners[2]) - a));
  Sides sides;
  for (const FlatTriangle& other : scene.triangles)
    for (const Float3& corner : scene.corners(other)) {
      const Vector3 p = toVector3(corner);
      const double height = glm::dot(p - a, n);
      sides.add(height, height, rounding(std::max(own, largestOf(p))));
    }
  for (const FlatSphere& sphere : scene.spheres) {
    const double height = glm::dot(toVector3(sphere.centre) - a, n);
    sides.add(height - radiusOf(sphere), height + radiusOf(sphere),
              rounding(std::max(own, magnitudeOf(sphere))));
  }
  // A lamp whose back is turned to the scene hides itself from whoever forgets its cosine.
  const bool shines = scene.shapes[triangle.shape].emission != Float3{};
  return sides.above || (!shines && sides.below);
}

bool surroundsScene(const FlatSceneView& scene, const FlatSphere& sphere) {
  const Vector3 centre = toVector3(sphere.centre);
  const double own = magnitudeOf(sphere);
  const auto within = [&](const Vector3& p, double radius, double magnitude) {
    return glm::distance(p, centre) + radius <=
           radiusOf(sphere) + rounding(std::max(own, magnitude));
  };
  return std::all_of(scene.triangles.begin(), scene.triangles.end(),
                     [&](const FlatTriangle& t) {
                       const auto corners = scene.corners(t);
                       return std::all_of(corners.begin(), corners.end(), [&](const Float3& p) {
                         return within(toVector3(p), 0.0, largestOf(toVector3(p)));
                       });
                     }) &&
         std::all_of(scene.spheres.begin(), scene.spheres.end(), [&](const FlatSphere& other) {
           return within(toVector3(other.centre), radiusOf(other), magnitudeOf(other));
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
  return {indicesOf(scene.triangles, [&](const FlatTriangle& t) { return !boundsScene(scene, t); }),
          indicesOf(scene.spheres, [&](const FlatSphere& s) { return !surroundsScene(scene, s); })};
}

Occluders allPrimitives(const FlatSceneView& scene) {
  Occluders all{std::vector<std::uint32_t>(scene.triangles.size()),
                std::vector<std::uint32_t>(scene.spheres.size())};
  std::iota(all.triangles.begin(), all.triangles.end(), 0u);
  std::iota(all.spheres.begin(), all.spheres.end(), 0u);
  return all;
}

}  // namespace pathmark
