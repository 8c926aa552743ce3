// Part 8, bonus: multiple importance sampling. Handout: handouts/part8_mis.md
//
// All densities that are compared in this part are per unit SOLID ANGLE.
#include <pathmark/coursework.h>

namespace pathmark {

// Part 8.1 (handout section 8.1): the weight of a sample that two techniques can draw.
//
// A sample that was drawn with the density a, and that the other technique would have drawn with
// the density b, counts a^2 / (a^2 + b^2). Densities may be 0, and so large that their squares are
// infinite: divide by the larger one first. (Veach 1997, section 9.2.2)
//
//   a, b   densities of the same measure, in [0, inf]
//
// Returns the weight, in [0,1]: 0 for a = 0, and 1/2 where both are infinite.
float powerHeuristic(float /*a*/, float /*b*/) {
  PATHMARK_UNIMPLEMENTED("part8_mis.cpp", "powerHeuristic");
  return 0.0f;
}

// Part 8.2 (handout section 8.2): the density of a point on a light, as a density of directions.
//
// Part 2's densities are per unit area of the light, those of parts 3 and 4 per unit solid angle.
// The area dA at y fills the solid angle dA cos(theta_y) / r^2 as seen from x, and so the density
// per unit solid angle is y.pdf r^2 / cos(theta_y). (Veach 1997, section 8.2.2.2)
//
//   from   the point x that is lit
//   y      a point of a light, its normal, and its density per unit area
//
// Returns the density per unit solid angle; 0 if y.pdf is 0, if x is behind the light
// (cos(theta_y) <= 0), or if x and y are the same point.
float solidAnglePdf(const Point& /*from*/, const LightSample& /*y*/) {
  PATHMARK_UNIMPLEMENTED("part8_mis.cpp", "solidAnglePdf");
  return 0.0f;
}

// Part 8.3 (handout section 8.3): the path tracer of part 5, which now finds lights in two ways.
//
// At each hit, as in part 5,
//   take a point of a light, which adds its direct light: but now times the weight
//     powerHeuristic(density of the light sample, density with which the BRDF draws its direction),
//   and draw the next direction with hit.brdf->reflection(...).
// Where the ray in that direction meets a light, its emission is no longer left out: it is direct
// light of the hit before, found the other way, and counts times the weight
//     powerHeuristic(density of the direction, density with which part 2 draws this point).
// The latter is hit.light->pdf(x, hit) per unit area, x the hit before; if you sample one light of
// several, with probability P, then the density of its points is P times as large, in both weights.
//
// What the camera sees directly counts fully. The last direct light that is counted is that of hit
// number maxBounces(): its second half needs one ray more than in part 5, and no light sample at
// the ray's end. Everything else is as in part 5, the roulette too. (Veach & Guibas 1995)
//
//   ray       a camera ray
//   sampler   all random numbers of the path: next1D(), next2D()
//
// Returns the radiance that comes back along the ray, with the same mean as tracePath.
Colour LitScene::tracePathMIS(const Ray& /*ray*/, Sampler& /*sampler*/) const {
  PATHMARK_UNIMPLEMENTED("part8_mis.cpp", "LitScene::tracePathMIS");
  return Colour(0.0f);
}

}  // namespace pathmark
