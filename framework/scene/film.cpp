#include "scene/film.h"

#include "scene/to_float.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pathmark {
namespace {

// Sine of the smallest angle between the view direction and `up`.
constexpr double kParallel = 1e-9;

}  // namespace

glm::dvec3 safeNormalize(const glm::dvec3& v) {
  const glm::dvec3 scaled = v / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return scaled / glm::length(scaled);
}

FlatCamera makeFilm(const CameraDescription& camera, int width, int height, const Place& place) {
  const glm::dvec3 forward = safeNormalize(camera.target - camera.eye);
  const glm::dvec3 side = glm::cross(forward, safeNormalize(camera.up));
  if (glm::length(side) <= kParallel) {
    Place(place, "up")
        .refuse("the direction in which the camera looks", "\"up\" must point to a side of it");
  }
  const glm::dvec3 right = glm::normalize(side);
  const glm::dvec3 up = glm::cross(right, forward);

  const double halfHeight = std::tan(camera.fieldOfView * (std::numbers::pi / 360.0));
  const double halfWidth = halfHeight * width / height;
  const double distance = 1.0 / std::max({1.0, halfHeight, halfWidth});
  const double pixel = 2.0 * halfHeight * distance / height;

  FlatCamera film;
  film.topLeft = toFloat3(distance * (forward - halfWidth * right + halfHeight * up));
  film.pixelRight = toFloat3(pixel * right);
  film.pixelDown = toFloat3(-pixel * up);
  film.width = static_cast<std::uint32_t>(width);
  film.height = static_cast<std::uint32_t>(height);
  return film;
}

bool isResolved(const FlatCamera& camera) {
  constexpr double kStepsPerPixel = 8.0;
  const double spacing = std::numeric_limits<float>::epsilon();
  return glm::length(toDouble3(camera.pixelRight)) >=
         kStepsPerPixel * spacing * glm::length(toDouble3(camera.topLeft));
}

}  // namespace pathmark
