// A receiver before lights that can be sampled: the rooms of 8.3.
#pragma once

#include "checks/lit_room.h"
#include "checks/path_estimates.h"
#include "checks/points.h"
#include "scene/flat_scene.h"

#include <array>
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

// A box of which all walls emit and reflect alike, so that what comes from any of them is known,
// and in it a small surface that draws directions with quite another density than the walls.
class ConeInBox {
 public:
  explicit ConeInBox(Random& random);

  FlatScene scene() const;
  PathRay ray(int bounces) const;          // looks at the small surface
  glm::dvec3 radiance(int bounces) const;  // along that ray; nothing in green
  std::string text() const;

  static constexpr std::array kLit{0, 2};  // channels

 private:
  float length_;  // of the box's sides
  Colour emission_;
  Vector wo_{0.0f};
};

}  // namespace pathmark::checks::path
