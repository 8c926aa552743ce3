// Scenes that nobody has seen before, and what can be done to a scene.
//
//   randomRoom        a room with two lamps and two balls, all by the seed
//   randomFurnace     closed, all surfaces emit and reflect the same
//   scaledEmission, withoutLight, moved
#pragma once

#include "checks/scenes.h"

#include <cstdint>

namespace pathmark::checks {

// Light 0 is a rectangle, light 1 a sphere.
FlatScene randomRoom(std::uint64_t seed);

// An inward sphere with a few spheres in it, the eye between them. With at most B scattering events
// the radiance is everywhere E (1 - kd^(B + 1)) / (1 - kd).
struct Furnace {
  FlatScene scene;
  Colour emission, kd;

  double radiance(int channel) const;
};
Furnace randomFurnace(std::uint64_t seed);

FlatScene scaledEmission(FlatScene scene, const Colour& factor);
FlatScene withoutLight(FlatScene scene, std::size_t light);

// Turned, scaled and shifted with its camera: the picture is the same.
FlatScene moved(FlatScene scene, std::uint64_t seed);

}  // namespace pathmark::checks
