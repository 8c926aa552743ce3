#include "render/light_reach.h"

#include "geometry/light_bounds.h"
#include "math/rounding.h"

#include <algorithm>

namespace pathmark {

void LightReach::add(std::span<const Light::Face> faces) {
  const Sphere around = sphereAround(faces);
  add({around.centre(), 0.0f, around.radius(),
       largestComponent(around.centre()) + around.radius()});
}

void LightReach::add(const Sphere& sphere) {
  const float magnitude = largestComponent(sphere.centre()) + sphere.radius();
  const float rounding = offsetForMagnitude(magnitude);
  add({sphere.centre(), sphere.radius() - rounding, sphere.radius() + rounding, magnitude});
}

void LightReach::add(const Shell& shell) {
  constexpr float kAlike = 4.0f;
  most_ = std::max(most_, shell.magnitude);
  least_ = shells_.empty() ? shell.magnitude : std::min(least_, shell.magnitude);
  alike_ = most_ <= kAlike * least_;
  shells_.push_back(shell);
}

float LightReach::magnitudeOfThoseAt(const Point& y) const {
  float magnitude = 0.0f;
  for (const Shell& shell : shells_) {
    if (shell.magnitude <= magnitude) continue;
    const float distance = length(y - shell.centre);
    if (distance >= shell.nearest && distance <= shell.farthest) magnitude = shell.magnitude;
  }
  return magnitude;
}

}  // namespace pathmark
