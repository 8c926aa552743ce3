// Light between plates, by quadrature in double: what one bounce and a whole path must give.
//
//   Plate          a parallelogram that emits on both sides and reflects on that of its normal
//   bounce         the light that a point of a surface reflects from one plate
//   betweenPlates  the light of a path between two plates that face each other
#pragma once

#include <pathmark/types.h>

#include <functional>

namespace pathmark::checks {

struct Plate {
  glm::dvec3 corner, v1, v2, normal;
  glm::dvec3 colour{0.0}, emission{0.0};
};

// What a bounce multiplies by, with a reflectance of 1, by the cosine of the direction that is
// uniform on the hemisphere: rightly 1/pi 2 pi cos(theta).
using BounceFactor = std::function<double(double cosine)>;

inline double diffuseFactor(double cosine) { return 2.0 * cosine; }

// Mean of the factor over the directions from x that hit the plate, the others counting as 0: for
// a plate of radiance 1. The plate lies above the horizon.
double bounce(const glm::dvec3& x, const glm::dvec3& n, const Plate& plate,
              const BounceFactor& factor = diffuseFactor);

// Radiance from x on `from` after at most `hits` hits, that on x included. Both plates see each
// other completely, from the sides of their normals.
glm::dvec3 betweenPlates(const glm::dvec3& x, const Plate& from, const Plate& to, int hits,
                         const BounceFactor& factor = diffuseFactor);

}  // namespace pathmark::checks
