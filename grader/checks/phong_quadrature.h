// Integrals over all directions of functions that are smooth but for the edges of Phong's lobes:
// the horizon, and 90 degrees from the mirror direction.
//
//   PhongFrame    coordinates around the mirror direction, and cells
//   phongNodes    directions and their weights
#pragma once

#include "checks/phong_oracle.h"

#include <vector>

namespace pathmark::checks {

// alpha from the mirror direction, azimuth from the plane of incidence, on the normal's side.
struct PhongFrame {
  // Rings of equal mass of the specular lobe, and one for all that is beyond it, by quarter turns.
  static constexpr int kRings = 5, kSectors = 4;
  static constexpr std::size_t kCells = std::size_t{kRings} * kSectors;

  explicit PhongFrame(const PhongLobes& lobes);

  glm::dvec3 direction(double alpha, double azimuth) const;
  double azimuth(const glm::dvec3& wi) const;  // in [-pi, pi]

  // cos^(m+1)(alpha): uniform in [0,1) under the specular lobe; 0 beyond it.
  double lobeQuantile(const glm::dvec3& wi) const;

  std::size_t cellOf(const glm::dvec3& wi) const;

  glm::dvec3 mirror, inPlane, across;
  glm::dvec3 tangent;  // of the surface, in the plane of incidence
  double cosR, sinR;   // of the angle between mirror direction and normal
  double m;
};

struct PhongNode {
  glm::dvec3 wi;
  double weight;  // solid angle
  bool above;
  std::size_t cell;
};

// Gauss-Legendre between the edges of cells, lobes and horizon.
std::vector<PhongNode> phongNodes(const PhongLobes& lobes);

}  // namespace pathmark::checks
