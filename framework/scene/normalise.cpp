#include "scene/normalise.h"

#include <algorithm>
#include <cmath>

namespace pathmark {
namespace {

constexpr double kSmallestComfortable = 1e-2;
constexpr double kLargestComfortable = 1e4;
constexpr double kNearOrigin = 4.0;

struct Box {
  glm::dvec3 low, high;

  void include(const glm::dvec3& point, double radius = 0.0) {
    low = glm::min(low, point - radius);
    high = glm::max(high, point + radius);
  }
};

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

Box boundingBox(const SceneDescription& scene) {
  Box box{scene.camera.eye, scene.camera.eye};
  for (const ShapeDescription& shape : scene.shapes) {
    if (shape.kind == ShapeKind::kSphere) box.include(shape.centre, shape.radius);
    for (const glm::dvec3& vertex : shape.vertices) box.include(vertex);
  }
  return box;
}

}  // namespace

Normalisation chooseNormalisation(const SceneDescription& scene) {
  const Box box = boundingBox(scene);
  const double halfExtent = largest((box.high - box.low) * 0.5);
  const glm::dvec3 centre = (box.low + box.high) * 0.5;

  Normalisation result;
  // An extent of zero (one point, or nothing but an eye) has no scale of its own.
  const double near = halfExtent > 0.0 ? kNearOrigin * halfExtent : kLargestComfortable;
  if (largest(glm::abs(centre)) > near) {
    result.shift = {centre.x, centre.y, centre.z};
  }
  const bool comfortable = halfExtent >= kSmallestComfortable && halfExtent <= kLargestComfortable;
  if (!comfortable && halfExtent > 0.0) {
    // Clamped, because the inverse of a denormal extent is no number.
    result.scale = std::ldexp(1.0, -std::clamp(std::ilogb(halfExtent), -1000, 1000));
  }
  return result;
}

bool isIdentity(const Normalisation& normalisation) {
  return normalisation.scale == 1.0 && normalisation.shift == std::array{0.0, 0.0, 0.0};
}

glm::dvec3 normalisedPoint(const Normalisation& normalisation, const glm::dvec3& point) {
  const auto& s = normalisation.shift;
  return (point - glm::dvec3(s[0], s[1], s[2])) * normalisation.scale;
}

double normalisedLength(const Normalisation& normalisation, double length) {
  return length * normalisation.scale;
}

void normalise(SceneDescription& scene, const Normalisation& normalisation) {
  scene.camera.eye = normalisedPoint(normalisation, scene.camera.eye);
  for (ShapeDescription& shape : scene.shapes) {
    shape.centre = normalisedPoint(normalisation, shape.centre);
    shape.radius = normalisedLength(normalisation, shape.radius);
    for (glm::dvec3& vertex : shape.vertices) vertex = normalisedPoint(normalisation, vertex);
  }
}

}  // namespace pathmark
