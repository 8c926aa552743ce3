// Irradiance from lights of constant radiance 1, in double.
//
//   polygonIrradiance   Lambert's formula, the polygon clipped at the receiver's horizon
//   sphereIrradiance    by quadrature over the cone, cut at the horizon in closed form
#pragma once

#include <pathmark/types.h>

#include <vector>

namespace pathmark::checks {

// At the point x of a surface with normal n. The vertices run counter-clockwise seen from the
// front; 0 from behind. Concave polygons too, if they are wholly above the horizon.
double polygonIrradiance(const std::vector<glm::dvec3>& vertices, const glm::dvec3& x,
                         const glm::dvec3& n);

// A sphere under the angle asin(sinMax) around a direction that makes the cosine `cosAxis` with
// the receiver's normal.
double sphereIrradiance(double sinMax, double cosAxis);

}  // namespace pathmark::checks
