#include "checks/shells.h"

#include <cmath>

namespace pathmark::checks {

Shells::Shells(Random& random, std::span<const Shell> shells, bool outermostInwards)
    : room(random, 1.0) {
  constexpr double kGrowth = 1.6;
  for (std::size_t k = 0; k < shells.size(); ++k) {
    const double size = std::pow(kGrowth, static_cast<double>(k));
    const double side = outermostInwards && k + 1 == shells.size() ? 1.0 : -1.0;
    for (std::size_t face = 0; face < 4; ++face)
      mesh.triangle(size * room.corner(face, 0), size * room.corner(face, 1),
                    size * room.corner(face, 2), side * room.normal(face), Colour(shells[k].colour),
                    Colour(shells[k].emission));
  }
}

glm::dvec3 throughShells(std::span<const Shell> shells, std::size_t hits) {
  glm::dvec3 sum(0.0), throughput(1.0);
  for (const Shell& shell : shells.first(hits)) {
    sum += throughput * shell.emission;
    throughput *= shell.colour;
  }
  return sum;
}

std::vector<Shell> faintShells() {
  return {{{0.1, 0.15, 0.2}, {1.0, 2.0, 0.5}},      {{0.1, 0.05, 0.1}, {0.8, 1.0, 0.3}},
          {{0.2, 0.1, 0.05}, {8.0, 20.0, 2.0}},     {{0.1, 0.2, 0.2}, {30.0, 200.0, 40.0}},
          {{0.5, 0.5, 0.5}, {400.0, 900.0, 250.0}}, {{0.5, 0.5, 0.5}, {900.0, 900.0, 900.0}}};
}

std::vector<Shell> blackShells() {
  return {{{0.3, 0.2, 0.0}, {1.0, 2.0, 0.5}}, {{0.0, 0.5, 0.5}, {0.5, 1.0, 1.0}},
          {{0.5, 0.4, 0.5}, {1.0, 2.0, 1.0}}, {{0.5, 0.8, 0.5}, {0.0, 0.0, 0.0}},
          {{0.5, 0.5, 0.5}, {1.0, 6.0, 1.0}}, {{0.5, 0.5, 0.5}, {9.0, 9.0, 9.0}}};
}

}  // namespace pathmark::checks
