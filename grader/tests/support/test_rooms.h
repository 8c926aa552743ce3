// Scenes in which all of the coursework has something to do.
#pragma once

#include "tests/support/test_scene.h"

namespace pathmark::testing {

// An inward sphere and a smaller sphere in it, both emitting `emission` and reflecting half of
// what they receive: everything in between has the radiance emission (2 - 2^-B) after at most B
// scattering events.
inline SceneBuilder furnace(float emission = 0.5f) {
  const Surface surface{.kd = Colour(0.5f), .emission = Colour(emission)};
  SceneBuilder builder;
  builder.sphere(surface, {0, 0, 0}, 2.0f, true).sphere(surface, {0.5f, -0.25f, 0.25f}, 0.5f);
  return builder;
}

// A room open to the front, of coloured walls, with a lamp under the ceiling, a bright sphere and
// a sphere that reflects by the two lobes of Phong's model. Nothing in it is 1 or symmetric. Large
// lights, so that estimators without direct lighting converge too.
inline SceneBuilder unevenRoom() {
  const Vector x(2, 0, 0), y(0, 1.5f, 0), z(0, 0, 3);
  SceneBuilder builder;
  builder.parallelogram({.kd = Colour(0.7f, 0.6f, 0.5f)}, Point(0), z, x);
  builder.parallelogram({.kd = Colour(0.8f)}, y, x, z);
  builder.parallelogram({.kd = Colour(0.9f, 0.1f, 0.2f)}, Point(0), y, z);
  builder.parallelogram({.kd = Colour(0.1f, 0.7f, 0.3f), .ks = Colour(0.3f), .exponent = 3.5f}, x,
                        z, y);
  builder.parallelogram({.kd = Colour(0.5f, 0.5f, 0.9f)}, Point(0), x, y);
  builder.parallelogram({.kd = Colour(0.3f), .emission = Colour(4, 5, 6)}, {0.4f, 1.4f, 0.6f},
                        {1.1f, 0, 0}, {0, 0, 1.3f});
  builder.sphere({.kd = Colour(0.1f, 0.2f, 0.1f), .emission = Colour(6, 3, 1)}, {0.45f, 0.4f, 1.2f},
                 0.3f);
  builder.sphere({.kd = Colour(0.2f, 0.1f, 0.3f), .ks = Colour(0.6f, 0.7f, 0.3f), .exponent = 7.3f},
                 {1.4f, 0.45f, 0.9f}, 0.4f);
  builder.camera({1.0f, 0.75f, 4.5f}, {1.0f, 0.7f, 0.0f}, 0.55, 12, 8);
  return builder;
}

}  // namespace pathmark::testing
