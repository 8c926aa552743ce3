// MattRoom: a closed room of six matt walls that emit and reflect, each as much as it likes, and
// what is seen of it after two bounces at most: a path that goes on from the wrong place or in the
// wrong direction meets another wall than it should.
#pragma once

#include "checks/scenes.h"

#include <array>
#include <cstdint>

namespace pathmark::checks {

class MattRoom {
 public:
  // The room [0, 3] x [0, 2.2] x [0, 2.6], its walls' colours by the seed.
  explicit MattRoom(std::uint64_t seed);

  static constexpr int kWalls = 6;

  // The point of a wall at shares u, v of its sides, and the normal into the room.
  glm::dvec3 point(int wall, double u, double v) const;
  glm::dvec3 normal(int wall) const { return walls_.at(static_cast<std::size_t>(wall)).n; }

  // Radiance that leaves the wall there after at most `bounces`, 0 to 2. After the second it is a
  // numerical integral, good to 1e-5 for points that are not next to an edge of the wall.
  glm::dvec3 radiance(int wall, const glm::dvec3& point, int bounces) const;

  SceneBuilder scene() const;

 private:
  struct Wall {
    glm::dvec3 corner, v1, v2, n;  // v1 x v2 points along n, into the room
    glm::dvec3 emission, kd;
  };

  glm::dvec3 afterOneBounce(int wall, const glm::dvec3& point) const;

  std::array<Wall, kWalls> walls_;
};

}  // namespace pathmark::checks
