// Shells: closed surfaces one inside the other, with their normals outwards. A path from the inside
// hits each of them once, from behind, and goes on through it.
//
//   Shell           of one colour and emission
//   Shells          the mesh, and where a path may start
//   throughShells   the mean radiance of a path from the inside, exactly
#pragma once

#include "checks/radiance_checks.h"

#include <span>
#include <vector>

namespace pathmark::checks {

struct Shell {
  glm::dvec3 colour, emission;
};

struct Shells {
  EvenRoom room;  // the innermost shell's place
  MeshWords mesh;

  // From the inside to the outside, in a room that looks inwards if `outermostInwards`.
  Shells(Random& random, std::span<const Shell> shells, bool outermostInwards = false);
};

// Of the first `hits` hits: each bounce has the mean factor a.
glm::dvec3 throughShells(std::span<const Shell> shells, std::size_t hits);

// Every term is a small share of what the first shell emits, so that few paths are enough.
//   faintShells   the throughput becomes small, and then there is a bright light
//   blackShells   blue ends at the first shell, red at the second, and the fourth does not emit
std::vector<Shell> faintShells();
std::vector<Shell> blackShells();

}  // namespace pathmark::checks
