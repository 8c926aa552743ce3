#include "preview/samples/orbit.h"

#include "preview/samples/direction_frame.h"

namespace pathmark::preview {

namespace {

constexpr double kDistance = 4.0;  // of the eye, in radii
constexpr double kMostTilt = 89.0 * kDegree;
constexpr double kSmallest = 0.4, kLargest = 20.0;  // zoom

}  // namespace

Orbit::Orbit(const Sketch& sketch)
    : centre_(sketch.centre),
      up_(sketch.up),
      right_(1, 0, 0),
      front_(glm::cross(right_, up_)),
      radius_(sketch.radius),
      turn_(sketch.flat ? 0.0 : 25.0 * kDegree),
      tilt_(sketch.flat ? 0.0 : 20.0 * kDegree) {}

void Orbit::lookAt(const Sketch& sketch) {
  centre_ = sketch.centre;
  radius_ = sketch.radius;
}

void Orbit::drag(const glm::dvec2& by) {
  turn_ -= std::numbers::pi * by.x;
  tilt_ = std::clamp(tilt_ + std::numbers::pi * by.y, -kMostTilt, kMostTilt);
}

void Orbit::zoom(double steps) {
  zoom_ = std::clamp(zoom_ * std::pow(1.15, steps), kSmallest, kLargest);
}

glm::dvec3 Orbit::project(const glm::dvec3& point) const {
  const glm::dvec3 ahead = std::cos(turn_) * front_ + std::sin(turn_) * right_;
  const glm::dvec3 across = std::cos(turn_) * right_ - std::sin(turn_) * front_;
  const glm::dvec3 towards = std::cos(tilt_) * ahead + std::sin(tilt_) * up_;
  const glm::dvec3 upwards = std::cos(tilt_) * up_ - std::sin(tilt_) * ahead;
  const glm::dvec3 p = (point - centre_) / radius_;
  const double depth = glm::dot(p, towards);
  const double scale = zoom_ * kDistance / std::max(kDistance - depth, 0.1 * kDistance);
  return {scale * glm::dot(p, across), scale * glm::dot(p, upwards), depth};
}

}  // namespace pathmark::preview
