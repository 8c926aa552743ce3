#include "checks/scenes.h"

#include <cmath>

namespace pathmark::checks {

namespace {

Float3 toFloat3(const vec3& v) { return {v.x, v.y, v.z}; }
Float3 toFloat3(const glm::dvec3& v) { return toFloat3(vec3(v)); }

}  // namespace

std::uint32_t SceneBuilder::material(const Surface& surface) {
  const bool phong = surface.ks != Colour(0.0f);
  flat_.materials.push_back({phong ? FlatMaterialKind::kPhong : FlatMaterialKind::kLambertian,
                             toFloat3(surface.kd), toFloat3(surface.ks), surface.exponent});
  return static_cast<std::uint32_t>(flat_.materials.size() - 1);
}

std::uint32_t SceneBuilder::addShape(const Surface& surface) {
  flat_.shapes.push_back(
      {material(surface), surface.frontOnly ? 1u : 0u, toFloat3(surface.emission)});
  return static_cast<std::uint32_t>(flat_.shapes.size() - 1);
}

SceneBuilder& SceneBuilder::polygon(const Surface& surface, const std::vector<Point>& vertices) {
  const std::uint32_t shape = addShape(surface);
  const glm::dvec3 a(vertices[0]), b(vertices[1]), c(vertices[2]);
  const Float3 normal = toFloat3(glm::normalize(glm::cross(b - a, c - a)));
  const auto count = static_cast<std::uint32_t>(vertices.size());
  FlatFace face{static_cast<std::uint32_t>(flat_.lightVertices.size()),
                count,
                static_cast<std::uint32_t>(flat_.lightTriangles.size()),
                count - 2,
                normal,
                1.0f};
  for (std::uint32_t i = 2; i < count; ++i) {
    flat_.addTriangle({toFloat3(vertices[0]), toFloat3(vertices[i - 1]), toFloat3(vertices[i])},
                      normal, shape);
  }
  if (surface.emission == Colour(0.0f)) return *this;
  for (const Point& v : vertices) flat_.lightVertices.push_back(toFloat3(v));
  for (std::uint32_t i = 2; i < count; ++i) flat_.lightTriangles.push_back({0, i - 1, i});
  flat_.lights.push_back({FlatLight::kNoSphere, static_cast<std::uint32_t>(flat_.faces.size()), 1,
                          toFloat3(surface.emission)});
  flat_.faces.push_back(face);
  return *this;
}

SceneBuilder& SceneBuilder::parallelogram(const Surface& surface, const Point& a, const Vector& v1,
                                          const Vector& v2) {
  return polygon(surface, {a, a + v1, a + v1 + v2, a + v2});
}

SceneBuilder& SceneBuilder::sphere(const Surface& surface, const Point& centre, float radius,
                                   bool inward) {
  const std::uint32_t shape = addShape(surface);
  flat_.spheres.push_back({toFloat3(centre), radius, shape, inward ? 1u : 0u});
  if (surface.emission != Colour(0.0f)) {
    flat_.lights.push_back(
        {static_cast<std::uint32_t>(flat_.spheres.size() - 1), 0, 0, toFloat3(surface.emission)});
  }
  return *this;
}

SceneBuilder& SceneBuilder::camera(const Point& eye, const Point& target, double fov, int width,
                                   int height) {
  const glm::dvec3 forward = glm::normalize(glm::dvec3(target) - glm::dvec3(eye));
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
  const glm::dvec3 down = glm::cross(forward, right);
  const double pixel = 2.0 * std::tan(0.5 * fov) / height;
  flat_.camera.eye = toFloat3(eye);
  flat_.camera.topLeft =
      toFloat3(forward - 0.5 * width * pixel * right - 0.5 * height * pixel * down);
  flat_.camera.pixelRight = toFloat3(pixel * right);
  flat_.camera.pixelDown = toFloat3(pixel * down);
  flat_.camera.width = static_cast<std::uint32_t>(width);
  flat_.camera.height = static_cast<std::uint32_t>(height);
  return *this;
}

SceneBuilder& SceneBuilder::maxBounces(int bounces) {
  flat_.maxBounces = static_cast<std::uint32_t>(bounces);
  return *this;
}

FlatScene emptyRoom() {
  SceneBuilder builder;
  builder.material({.kd = Colour(0.5f)});
  return builder.camera({0, 0, 3}, {0, 0, 0}, 0.8, 8, 8).flat();
}

}  // namespace pathmark::checks
