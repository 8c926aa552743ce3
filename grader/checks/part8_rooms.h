// A receiver before lights that can be sampled: the rooms of 8.3.
#pragma once

#include "checks/lit_room.h"
#include "checks/path_estimates.h"
#include "checks/points.h"
#include "scene/flat_scene.h"

#include <string>
#include <vector>

namespace pathmark::checks::path {

// A throughput that is black in red or green keeps the roulette's stand-in from ending paths, which
// would be most of the noise.
enum class Black { kRed, kGreen };

struct Case {
  std::string what;
  LitRoom room;
  double size = 1.0;  // of the room
  std::uint32_t paths = 512;
  Black black = Black::kGreen;
  bool isDark = false;  // in some channel, or in all

  PathRay ray() const {
    const Receiver& x = room.receiver;
    return {{x.p + static_cast<float>(1e-2 * size) * x.wo, -x.wo}, 1};
  }
};

// The room with its receiver as a small surface, which the ray of the case looks at.
FlatScene sceneOf(const Case& c);

// Lights over a receiver at the origin, whose BRDF is the lopsided one.
LitRoom below(std::vector<RoomLight> lights, Random& random);

// Above that receiver, around which it stands somewhere.
RoomLight above(Random& random, double height, double width, double depth);

std::vector<Case> directLightCases(std::uint64_t seed);

}  // namespace pathmark::checks::path
