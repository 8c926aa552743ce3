// A hollow sphere of the stand-in material, to look around in.
#pragma once

#include "checks/points.h"
#include "checks/scenes.h"

#include <pathmark/types.h>

#include <numbers>

namespace pathmark::checks {

// Any Ks that is not black makes it Phong's, whose stand-in looks at Kd only.
inline Surface lopsidedWall(const Colour& kd, const Colour& emission) {
  return {.kd = kd, .emission = emission, .ks = Colour(0.125f)};
}

// A sphere from within, somewhere.
struct Hollow {
  Point centre;
  float radius;

  explicit Hollow(Random& random)
      : centre(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)),
        radius(static_cast<float>(random.between(1.0, 3.0))) {}

  Hollow(Random& random, float size) : Hollow(random) { radius *= size; }

  // A ray from within that meets the wall at this cosine.
  Ray rayAt(double cosine, Random& random) const {
    const Vector n = random.direction();
    const Vector wo = atCosine(n, cosine, random.between(0.0, 2.0 * std::numbers::pi));
    const double chord = 2.0 * double{radius} * cosine;
    return {
        Point(glm::dvec3(centre) - double{radius} * glm::dvec3(n) + 0.4 * chord * glm::dvec3(wo)),
        -wo};
  }
};

// The wall of the hollow, and nothing else: it emits everywhere.
inline FlatScene furnaceIn(const Hollow& hollow, const Colour& kd, const Colour& emission) {
  SceneBuilder builder;
  return builder.sphere(lopsidedWall(kd, emission), hollow.centre, hollow.radius, true).flat();
}

}  // namespace pathmark::checks
